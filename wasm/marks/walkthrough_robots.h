#pragma once

#include <vector>

#include "marks/load_labels.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// The labels of the loads, once all loads are known. Names keep clear of these labels
// (canvas_walkthrough.cpp).
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// Draws the robots placed up to the current step.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
