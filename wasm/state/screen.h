// The size of the screen, and the scale of everything on it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// In CSS pixels, and device pixels per CSS pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// In presentation mode, what is open fills the screen. Call it when that may have changed. O(1).
void scale_screen(AppState& state);

// By a window of the page, in CSS pixels.
void cover_screen(AppState& state, double left, double right, double foot);

// For a card of this height, in CSS pixels, at the foot of the drawing; 0 undoes that.
void make_room(AppState& state, double height);

// Presentation mode enlarges everything in full screen, with an open walkthrough without settings.
void set_presenting(AppState& state, bool on);

}  // namespace evenlift::view
