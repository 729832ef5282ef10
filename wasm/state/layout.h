// The places of everything on the screen: side by side on a wide one, stacked on a narrow one.
#pragma once

#include "state/camera.h"
#include "state/state.h"

namespace evenlift::view {

inline constexpr double zoom_width = 52;  // of the zoom percentage among the view tools

struct Layout {
  bool wide = true;        // panel at the side; otherwise a sheet at the bottom
  double control = 32;     // of one control; larger for a finger
  double margin = 16;      // between panels and the canvas's edge
  double bar_padding = 8;  // between a bar's controls and its edge
  bool low = false;        // little height: seldom-used controls are in the toolbar's menu
  bool brief = false;      // the closed sheet shows only its first lines, to leave room for a card
  Rect panel;              // panel or sheet
  // While the walkthrough is open; in an <iframe>, always. On a narrow screen it is in the sheet.
  Rect player;
  // Only left and top matter: the width follows from the content. Empty in an <iframe> and in
  // presentation mode.
  Rect toolbar;
  Rect tools;          // zoom and fit; empty if the toolbar's menu has them
  Rect free;           // what nothing covers for long
  Rect first, second;  // the two pictures of a comparison; otherwise the whole, and empty
  // Of a strip at the top of each picture; the caption is at its foot.
  double caption = 0;
  Rect notice;  // it appears at the foot; independent of whether there is one
  Rect room;    // where a fitting view puts the polygon
};

Layout layout(const AppState& state);

// Whether a narrow screen's sheet can be half open. On a low screen the closed sheet is that high.
bool has_half_sheet(const AppState& state);

// Shows the polygon and its centre of mass, even outside; or, while the user draws over a photo,
// the whole photo. O(vertices).
Camera fitting_camera(const AppState& state);

// A card of the page goes at the foot of this rectangle and within it, and covers no control.
// Independent of whether there is one.
Rect card_seat(const AppState& state);

}  // namespace evenlift::view
