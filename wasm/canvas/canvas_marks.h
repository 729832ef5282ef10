// What stands on a picture at a fixed size: grips, robots, the centre of mass, numbers.
#pragma once

#include "canvas/canvas_view.h"

namespace evenlift::view {

void draw_marks(const Painter& painter, const CanvasView& view);

// What can be done with what is under the pointer, at the foot of the canvas.
void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme);
std::string hint(const AppState& state);  // empty if there is nothing to say

}  // namespace evenlift::view
