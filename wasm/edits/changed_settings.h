// What a change of settings changes.
#pragma once

#include "evenlift/document.h"
#include "state/history.h"

namespace evenlift::view {

// The settings with what places nothing taken over from others. O(1).
Settings placing_as(Settings settings, const Settings& other);

// Whether robots stand at the same places with both. O(1).
bool stand_alike(const Settings& a, const Settings& b);

// The setting that differs, if it is only one; of documents with the same vertices it may be the centre of mass. O(1).
Edit edit_between(const Settings& before, const Settings& after);
Edit edit_between(const Document& before, const Document& after);

}  // namespace evenlift::view
