// Sets the size of the screen, and the scale of everything on it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Sets the canvas's size in CSS pixels, and the number of device pixels per CSS pixel.
void set_canvas(AppState& state, double css_width, double css_height, double css_ratio);

// Scales everything for presentation mode, which enlarges a walkthrough more than the page with its
// settings. Call this when the mode may have changed, or a walkthrough may have been opened or
// closed. O(1).
void scale_screen(AppState& state);

// Notes how much of the canvas a window of the page covers at each side, in CSS pixels.
void cover_screen(AppState& state, double left, double right, double foot);

// Makes room for a card of this height, in CSS pixels, at the foot of the drawing. A height of 0
// removes the room.
void make_room(AppState& state, double height);

// Begins or ends presentation mode, which enlarges everything in full screen. An open walkthrough
// is shown without the settings.
void set_presenting(AppState& state, bool on);

}  // namespace evenlift::view
