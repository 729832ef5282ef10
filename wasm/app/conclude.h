// The consequences of a batch of commands, or of a function that replaced commands.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives the facts (derive/derive.h) and updates the view accordingly: the open step, the camera
// for larger robots, and the announcement of a refusal. Call it once after each batch.
void conclude(AppState& state);

// Places the document here if a worker is choosing its teams. Call it before anything that builds on
// the placement of the document, as it is after a drag.
void place_now(AppState& state);

}  // namespace evenlift::view
