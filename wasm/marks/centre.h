// Draws the centre of mass, and its possible error.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_centre(const Painter& painter, const CanvasView& view);

// Draws the tipping distance, and the C uncertainty as a ring with a grip.
void draw_halo(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
