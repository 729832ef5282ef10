// Draws everything of a fixed size on a picture: grips, robots, the centre of mass, numbers.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_marks(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
