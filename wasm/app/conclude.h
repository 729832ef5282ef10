// What follows from a batch of commands, or from what one function did in place of commands.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives what follows (derive/derive.h), and lets the view follow that: the open step, the camera
// for larger robots, and what is said of a refusal. Call it once after each batch.
void conclude(AppState& state);

}  // namespace evenlift::view
