#pragma once

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// Whether both settings put robots at the same places. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The edit of the setting that differs; Edit::settings if several do. The documents have the same
// vertices. O(bytes).
Edit edit_between(const Document& before, const Document& after);

// Returns `shown` with the values of `after` where `before` and `after` differ, except the step.
// O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

}  // namespace evenlift::view
