// What a change of settings changes.
#pragma once

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// Whether robots stand at the same places with both. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The edit of the setting that differs, if it is only one. The documents have the same vertices.
// O(bytes).
Edit edit_between(const Document& before, const Document& after);

// What is shown, with what differs between two others, but the step, as in the second. O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

}  // namespace evenlift::view
