// Where everything is on the screen: side by side on a wide one, above each other on a narrow one.
#pragma once

#include "state/camera.h"
#include "state/state.h"

namespace evenlift::view {

struct Layout {
  bool wide = true;     // panel at the side; otherwise a sheet at the bottom
  double control = 32;  // height of a control: more under a finger
  double margin = 16;   // between panels and the canvas's edge
  Rect panel;           // panel or sheet
  Rect player;          // while the walkthrough is open; on a narrow screen it is in the sheet
  Rect toolbar;         // left and top count; it is as wide as its content
  Rect tools;           // zoom and fit
  Rect free;            // canvas that nothing covers for long
  Rect first, second;   // the two pictures while methods are compared; else all of it and nothing
  Rect room;            // where the polygon goes when the view fits it
};

Layout layout(const AppState& state);

}  // namespace evenlift::view
