// The names of what a step of the walkthrough speaks of.
#pragma once

#include "picture/canvas_view.h"
#include "picture/labels.h"
#include "picture/painter.h"

namespace evenlift::view {

// Writes "edge 4" or "vertex 1" beside each part that the step is about, outside of the polygon,
// and "C" beside the centre of mass, all clear of what is occupied. O(vertices) for each of them.
void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied);

}  // namespace evenlift::view
