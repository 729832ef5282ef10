// How large the screen is, and how large everything on it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Tells what the browser says of the canvas: its size in CSS pixels, and device pixels per CSS pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// Whether the walkthrough is shown to a room: then without settings, and all of it larger.
void set_presenting(AppState& state, bool on);

}  // namespace evenlift::view
