#pragma once

#include "picture/canvas_view.h"
#include "picture/labels.h"
#include "picture/painter.h"

namespace evenlift::view {

// Writes a name such as "edge 4" or "vertex 1" beside each part that the step shows, on the outside
// of the polygon, and "C" beside the centre of mass. All names keep clear of occupied places.
// O(vertices) for each name.
void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied);

}  // namespace evenlift::view
