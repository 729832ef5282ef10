// The robots of a step of the walkthrough.
#pragma once

#include <vector>

#include "marks/load_labels.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// What is written beside them, once all loads are known; other names keep clear of it.
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// The robots placed up to the current step; their loads are written once all of them are known.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
