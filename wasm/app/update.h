// Applies commands to the state. The folder `edits` implements the longer commands.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any; if so,
// another frame is due. If a document is refused, the last good placement stays.
bool apply(AppState& state, Commands& commands);

}  // namespace evenlift::view
