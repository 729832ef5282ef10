// The effects of a change of settings.
#pragma once

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// Whether robots stand at the same places with both. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The edit of the differing setting, if only one differs. The documents have the same vertices.
// O(bytes).
Edit edit_between(const Document& before, const Document& after);

// `shown` with every value, except the step, that differs between `before` and `after` taken from
// `after`. O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

}  // namespace evenlift::view
