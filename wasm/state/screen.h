// How large the screen is, and how large everything on it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Tells what the browser says of the canvas: its size in CSS pixels, and device pixels per CSS
// pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// A window of the page covers so much of the canvas at its left, at its right and at its foot, in
// CSS pixels.
void cover_screen(AppState& state, double left, double right, double foot);

// Makes room for a card of this height, in CSS pixels, at the foot of the drawing; 0 ends that.
void make_room(AppState& state, double height);

// Whether the walkthrough is shown to a room: then without settings, and all of it larger.
void set_presenting(AppState& state, bool on);

}  // namespace evenlift::view
