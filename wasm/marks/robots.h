// Draws a placement's robots and their loads.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_robots(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
