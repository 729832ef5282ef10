// The picture of a step of the walkthrough: what is known after it, and on top the step's figures.
#pragma once

#include "canvas/canvas_view.h"

namespace evenlift::view {

void draw_walkthrough(const Painter& painter, const CanvasView& view);

// Whether a question is asked about balanced robots that the present step does not show. Then only
// these are drawn, and the chords to choose from.
bool asks_of_other_robots(const AppState& state);

}  // namespace evenlift::view
