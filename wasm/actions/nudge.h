// Moves parts of the drawing with the arrow keys.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Moves the drawing cursor to the next dot of the grid or, if `finely`, by about a pixel. If there
// is neither a cursor nor a drawn vertex, only shows the cursor. x and y are -1, 0 or 1, and one of
// them is 0.
void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely);

// Moves the first of these that applies: the drawing cursor, by a step of the grid; the polygon, by
// a step; the robot whose card is open, by a tenth of a step; or the selected vertex or weight, by
// a tenth of a step, or by a whole step if points snap to the grid.
void nudge(const AppState& s, Commands& out, int x, int y);

}  // namespace evenlift::view
