#pragma once

#include "picture/canvas_view.h"
#include "picture/painter.h"

namespace evenlift::view {

// Where a further load may stand, in green; the rest is striped. Nothing if the overlay is hidden,
// or if no load is asked about.
void draw_load_region(const Painter& painter, const CanvasView& view);

// Circles about C for slopes: where one reaches the edge of the lifting base, the object tips on
// that slope, if that direction is downhill.
void draw_tilt(const Painter& painter, const CanvasView& view);

// The load's effect at the pointer, or the slope at which the object tips that way. Returns whether
// it says anything.
bool draw_carrying_here(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
