// Arrows for free motions that the picture's regions do not show.
#pragma once

#include "picture/canvas_view.h"
#include "picture/labels.h"

namespace evenlift::view {

// Draws an arrow from the centre of mass in a direction in which the object can slide, with a label
// if there is room.
void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied);

// For each shown region of free rotation that lies outside the window, draws an arrow at the
// window's edge, towards the region, with a label if there is room. O(corners of the regions).
void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied);

}  // namespace evenlift::view
