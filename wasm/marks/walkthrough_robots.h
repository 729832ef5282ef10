#pragma once

#include <vector>

#include "marks/load_labels.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// The loads, once all are known. Names keep clear of them (canvas_walkthrough.cpp).
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// Those placed up to the current step.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
