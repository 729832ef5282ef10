// Derives the consequences of commands, or of functions called in place of commands.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives the facts (derive/derive.h), then updates the open step, the camera for larger robots,
// and the announcement of a refusal. Call it once after each batch.
void conclude(AppState& state);

// Places the document at once if a worker is still choosing its teams. Call it before using the
// placement that a drag leads to.
void place_now(AppState& state);

}  // namespace evenlift::view
