// The consequences of a batch of commands, or of a function that replaced commands.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives the facts (derive/derive.h) and updates the view accordingly: the open step, the camera
// for larger robots, and the announcement of a refusal. Call it once after each batch.
void conclude(AppState& state);

}  // namespace evenlift::view
