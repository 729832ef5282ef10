// Arrows that say how the object can still move, where the regions of the picture do not say it.
#pragma once

#include "picture/canvas_view.h"
#include "picture/labels.h"

namespace evenlift::view {

// An arrow from the centre of mass in a direction in which the object can slide, and its name where
// there is room.
void draw_slide(const Painter& painter, const CanvasView& view, Occupied* occupied);

// For each region of free rotation that is to be shown but lies beyond the window, an arrow at the
// window's edge that points to it, and what it says where there is room. O(corners of the regions).
void draw_far_regions(const Painter& painter, const CanvasView& view, Occupied* occupied);

}  // namespace evenlift::view
