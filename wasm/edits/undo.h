// Undo and redo.
#pragma once

#include "state/state.h"

namespace evenlift::view {

void undo(AppState& state);
void redo(AppState& state);

// Forgets a selection of, or a grip on, a vertex that no longer exists. O(1).
void drop_stale_picks(AppState& state);

}  // namespace evenlift::view
