// The places of everything on the screen: side by side on a wide screen, stacked on a narrow one.
// All sizes are pixels.
#pragma once

#include "state/camera.h"
#include "state/state.h"

namespace evenlift::view {

inline constexpr double zoom_width = 52;  // width of the zoom percentage in the view tools

struct Layout {
  bool wide = true;        // panel at the side; otherwise a sheet at the bottom
  double control = 32;     // height of a control; larger for a finger
  double margin = 16;      // between panels and the canvas's edge
  double bar_padding = 8;  // between a bar's controls and its edge
  bool low = false;        // the height is small: seldom-used controls are in the toolbar's menu
  bool bare = false;       // the closed sheet is only its handle
  bool brief = false;  // the closed sheet shows only its first lines, to leave room for the drawing
  Rect panel;          // the panel at the side, or the sheet
  // The player: the walkthrough's buttons and, in an <iframe> and in presentation mode, its words.
  // An <iframe> always has a player. Elsewhere the player is empty if no walkthrough is open, and
  // on a narrow screen outside presentation mode, where the sheet contains the buttons.
  Rect player;
  // The greatest room for the toolbar, which is as wide as its content; empty in an <iframe> and
  // while steps are presented.
  Rect toolbar;
  Rect tools;  // the view tools, such as zoom and fit; empty if the toolbar's menu has them
  Rect free;   // the part of the canvas that is covered only briefly, if at all
  // The two pictures of a comparison. Without a comparison, `first` is the whole drawing and
  // `second` is empty.
  Rect first, second;
  // The height of a strip at the top of each compared picture, with the caption at the strip's
  // foot.
  double caption = 0;
  Rect notice;  // a notice appears at the foot of this place
  Rect room;    // where fitting_camera() puts the polygon
};

Layout layout(const AppState& state);

// Returns whether a narrow screen's sheet can be half open. It cannot be on a low screen, where the
// closed sheet is about as high as a half-open one.
bool has_half_sheet(const AppState& state);

// Returns the camera that shows the polygon and its centre of mass, even if this centre is outside
// the polygon. While the user draws over a picture, the camera shows the whole picture.
// O(vertices).
Camera fitting_camera(const AppState& state);

// Returns the rectangle for a card of the page, whether or not there is a card. The card goes at
// the foot of the rectangle and within it, and covers no control.
Rect card_seat(const AppState& state);

}  // namespace evenlift::view
