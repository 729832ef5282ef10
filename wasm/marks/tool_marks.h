// What the tools show: the polygon that is being drawn, and the frame for moving, turning and
// scaling.
#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme);
void draw_frame_grips(const Painter& painter, const AppState& state, const Theme& theme);

// The number of an edge at its middle, as messages count edges: from 1.
void draw_edge_number(const Painter& painter, const Theme& theme, const Vec2& a, const Vec2& b,
                      std::size_t edge);

}  // namespace evenlift::view
