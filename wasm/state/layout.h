// Where everything is on the screen: side by side on a wide one, above each other on a narrow one.
#pragma once

#include "state/camera.h"
#include "state/state.h"

namespace evenlift::view {

inline constexpr double zoom_width = 52;  // of the zoom in per cent, among the tools of the view

struct Layout {
  bool wide = true;        // panel at the side; otherwise a sheet at the bottom
  double control = 32;     // height of a control: more under a finger
  double margin = 16;      // between panels and the canvas's edge
  double bar_padding = 8;  // between the controls of a bar and its edge
  bool low = false;        // little height: what is asked for seldom is in the toolbar's menu
  bool brief = false;  // the closed sheet shows its first lines only, since a card needs the room
  Rect panel;          // panel or sheet
  // While the walkthrough is open; on a narrow screen it is in the sheet; in an <iframe> always.
  Rect player;
  // Left and top count; it is as wide as its content. Empty in an <iframe> and before a room.
  Rect toolbar;
  Rect tools;          // zoom and fit; empty where the toolbar's menu has them
  Rect free;           // canvas that nothing covers for long
  Rect first, second;  // the two pictures while methods are compared; else all of it and nothing
  // Height of a strip at the top of each of the two, at whose foot its caption stands.
  double caption = 0;
  Rect
      notice;  // where a notice may stand, at the foot of this place; it does not depend on whether there is one
  Rect room;  // where the polygon goes when the view fits it
};

Layout layout(const AppState& state);

// Whether the sheet of a narrow screen can stand half open: on a low screen it is as high as that
// when it is closed.
bool has_half_sheet(const AppState& state);

// What the view shows when it fits: the polygon, and its centre of mass if that lies outside; or,
// while one draws over a photo, all of that. O(vertices).
Camera fitting_camera(const AppState& state);

// Where a card of the page may stand, at the foot of this place and not above it: it covers no
// control. It does not depend on whether there is a card.
Rect card_seat(const AppState& state);

}  // namespace evenlift::view
