// Derives the consequences of commands, or of functions called in place of commands.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Derives the facts (derive/derive.h). Then updates the open step and the announcement of a
// refusal. If the robots' size changed, the view will fit the window again unless the user has
// panned or zoomed. Call it once after each batch of commands.
void conclude(AppState& state);

// Places the document at once if a worker is still choosing its teams. Call it before a command
// that uses the robots of the present shape.
void place_now(AppState& state);

}  // namespace evenlift::view
