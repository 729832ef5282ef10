// What arrow keys, the pointer and fingers do to the drawing.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// --- Moves parts of the drawing with the arrow keys.

// Moves the drawing cursor to the next dot of the grid or, if `finely`, by about a pixel. If there
// is neither a cursor nor a drawn vertex, only shows the cursor. x and y are -1, 0 or 1, and one of
// them is 0.
void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely);

// Moves the first of these that applies: the drawing cursor, by a step of the grid; the polygon, by
// a step; the robot whose card is open, by a tenth of a step; or the selected vertex or weight, by
// a tenth of a step, or by a whole step if points snap to the grid.
void nudge(const AppState& s, Commands& out, int x, int y);

// --- The state of the pointer and of fingers in one frame, and the commands that follow from it.

struct Pointer {
  Vec2 at;                  // pixels
  bool present = false;     // over the canvas, or holding a part
  bool touch = false;       // a finger, which cannot hover
  bool second = false;      // over the picture of the second method
  bool over_panel = false;  // over a panel or popup
  bool pressed = false, down = false, released = false, double_pressed = false;
  double moved = 0;  // the greatest distance from the press so far, in pixels
  double wheel = 0;  // the wheel's steps, > 0 to zoom in
  // The pinch of two fingers, or of a trackpad.
  bool pinching = false;
  Vec2 pinch_at, pinch_moved;
  double pinch_factor = 1;
};

// Appends the commands that follow from the pointer. They drag, pan, zoom, add vertices, and note
// the part under the pointer.
void interact(const AppState& state, const Pointer& pointer, Commands& commands);

}  // namespace evenlift::view
