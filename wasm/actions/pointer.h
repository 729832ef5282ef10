// The state of the pointer and of fingers in one frame, and the commands that follow from it.
#pragma once

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

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
