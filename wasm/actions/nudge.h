// Moves parts of the drawing by arrow keys.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Moves the drawing cursor to the next dot of the grid or, finely, by a pixel. x and y are -1, 0 or
// 1, and one of them is 0.
void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely);

// Moves the drawing cursor, the polygon, the robot with the open card, or the selected vertex, by a
// step of the grid or a tenth of one.
void nudge(const AppState& s, Commands& out, int x, int y);

}  // namespace evenlift::view
