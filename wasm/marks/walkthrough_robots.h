// The robots of a step of the walkthrough.
#pragma once

#include <vector>

#include "marks/load_labels.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// The text beside the robots once all loads are known. Names keep clear of it
// (canvas_walkthrough.cpp).
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// The robots placed up to the current step.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
