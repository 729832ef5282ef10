// Draws the centre of mass, and its possible error.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_centre(const Painter& painter, const CanvasView& view);

// Draws the tipping distance as a dashed circle, and a ring within which the weight may act
// (DisturbanceEffect::reach), because of the C uncertainty, slopes or acceleration. In the first picture,
// the ring has the grip for the C uncertainty.
void draw_halo(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
