// The robots of a step of the walkthrough.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

// The robots placed up to the current step; their loads are written once all of them are known.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
