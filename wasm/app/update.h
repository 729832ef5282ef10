// Applies commands to the state. Longer commands are in the folder `edits`.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any, in which case
// another frame is due. When a document is refused, the last good placement stays.
bool apply(AppState& state, Commands& commands);

}  // namespace evenlift::view
