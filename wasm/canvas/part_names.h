// The names of the parts in a step of the walkthrough.
#pragma once

#include "picture/canvas_view.h"
#include "picture/labels.h"
#include "picture/painter.h"

namespace evenlift::view {

// Writes "edge 4" or "vertex 1" beside each part of the step, outside the polygon, and "C" beside
// the centre of mass, all clear of occupied places. O(vertices) for each of them.
void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied);

}  // namespace evenlift::view
