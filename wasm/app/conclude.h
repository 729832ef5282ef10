// The consequences of commands, or of functions called in their place.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives the facts (derive/derive.h), then updates the open step, the camera for larger robots,
// and the announcement of a refusal. Call it once after each batch.
void conclude(AppState& state);

// Places the document here if a worker is choosing its teams. Call it before using the placement as
// it is after a drag.
void place_now(AppState& state);

}  // namespace evenlift::view
