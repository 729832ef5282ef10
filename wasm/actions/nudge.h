// What arrow keys move on the drawing.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Moves the cursor of the drawing to the next dots of the grid, or by a pixel. x and y are -1, 0 or
// 1, one of them 0.
void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely);

// Moves the cursor of the drawing, the whole polygon, the robot whose card is open, or the selected
// vertex: by a dot of the grid or a tenth of one.
void nudge(const AppState& s, Commands& out, int x, int y);

}  // namespace evenlift::view
