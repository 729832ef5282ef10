// Applies commands to the state. What a command does beyond that is in the room edits.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any; then another
// frame is due. When a document is refused, the last good placement stays.
bool apply(AppState& state, Commands& commands);

}  // namespace evenlift::view
