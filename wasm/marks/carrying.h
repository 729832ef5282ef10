#pragma once

#include "picture/canvas_view.h"
#include "picture/painter.h"

namespace evenlift::view {

// Draws the places where a further load may stand, in green; the rest is striped. Draws nothing if
// the overlay is hidden, or if no load is asked about.
void draw_load_region(const Painter& painter, const CanvasView& view);

// Draws circles about C for slopes. Where a circle reaches the edge of the lifting base, the object
// tips on that slope, if that direction is downhill.
void draw_tilt(const Painter& painter, const CanvasView& view);

// Writes the load's effect at the pointer, or the slope at which the object tips in the pointer's
// direction. Returns whether it wrote anything.
bool draw_carrying_here(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
