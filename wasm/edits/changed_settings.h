#pragma once

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// Whether the settings agree in all values on which the robots' places depend. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The kind of edit to which the differing setting belongs; Edit::settings if the differing settings
// belong to several kinds, or if none differs. The documents must have the same vertices. O(bytes).
Edit edit_between(const Document& before, const Document& after);

// Returns `shown` with those values of `after` that differ from `before`, except the step.
// O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

}  // namespace evenlift::view
