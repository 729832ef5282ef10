// Draws a step of the walkthrough: everything known after the step and, on top, its figures.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
