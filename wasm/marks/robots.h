// The robots of a placement, with what they bear.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_robots(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
