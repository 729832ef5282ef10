// The size of the screen, and the scale of everything on it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Sets the size of the canvas in CSS pixels, and the device pixels per CSS pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// Scales everything for the present mode: in presentation mode, what is open fills the screen. Call
// it when that may have changed. O(1).
void scale_screen(AppState& state);

// A window of the page covers this much of the canvas at its left, right and foot, in CSS pixels.
void cover_screen(AppState& state, double left, double right, double foot);

// Makes room for a card of this height, in CSS pixels, at the foot of the drawing; 0 undoes that.
void make_room(AppState& state, double height);

// Turns presentation mode on or off: everything enlarged on the full screen, and an open
// walkthrough without settings.
void set_presenting(AppState& state, bool on);

}  // namespace evenlift::view
