// The places of everything on the screen: side by side on a wide one, above each other on a narrow
// one.
#pragma once

#include "state/camera.h"
#include "state/state.h"

namespace evenlift::view {

inline constexpr double zoom_width = 52;  // of the zoom percentage among the view tools

struct Layout {
  bool wide = true;        // panel at the side; otherwise a sheet at the bottom
  double control = 32;     // height of a control; larger for a finger
  double margin = 16;      // between panels and the canvas's edge
  double bar_padding = 8;  // between the controls of a bar and its edge
  bool low = false;        // little height: seldom-used controls are in the toolbar's menu
  bool brief = false;      // the closed sheet shows its first lines only, to leave room for a card
  Rect panel;              // panel or sheet
  // While the walkthrough is open. On a narrow screen it is in the sheet; in an <iframe> it is
  // always shown.
  Rect player;
  // Only left and top matter; the width follows from the content. Empty in an <iframe> and in
  // presentation mode.
  Rect toolbar;
  Rect tools;          // zoom and fit; empty if the toolbar's menu has them
  Rect free;           // canvas that nothing covers for long
  Rect first, second;  // the two pictures of a comparison; otherwise the whole, and empty
  // Height of a strip at the top of each picture; the caption is at its foot.
  double caption = 0;
  Rect notice;  // the notice appears at its foot; independent of whether there is one
  Rect room;    // where the polygon goes when the view fits it
};

Layout layout(const AppState& state);

// Whether a narrow screen's sheet can be half open. On a low screen the closed sheet already has
// that height.
bool has_half_sheet(const AppState& state);

// The camera of a view that fits: it shows the polygon, and its centre of mass even if outside; or,
// while the user draws over a photo, the whole photo. O(vertices).
Camera fitting_camera(const AppState& state);

// The place for a card of the page, at the foot of this rectangle and within it: it covers no
// control. Independent of whether there is a card.
Rect card_seat(const AppState& state);

}  // namespace evenlift::view
