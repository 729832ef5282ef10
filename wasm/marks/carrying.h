#pragma once

#include "picture/canvas_view.h"
#include "picture/painter.h"

namespace evenlift::view {

// Shows in green the region where a further load may stand, and draws stripes over the rest of the
// object. Draws nothing if the overlay is hidden, or if the user does not ask about a load.
void draw_load_region(const Painter& painter, const CanvasView& view);

// Draws circles about C, each for one slope. On that slope, under the assumptions of tilt.h, the
// object tips downhill if the circle reaches beyond the lifting base in that direction.
void draw_tilt(const Painter& painter, const CanvasView& view);

// Writes the load's effect at the pointer, or the slope at which the object tips towards the
// pointer. Returns whether it wrote anything.
bool draw_carrying_here(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
