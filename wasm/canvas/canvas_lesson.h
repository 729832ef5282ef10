// The lesson's picture: what is known after the step, and on top what the step is about.
#pragma once

#include "canvas/canvas_view.h"

namespace evenlift::view {

void draw_lesson(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
