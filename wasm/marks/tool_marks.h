// What the tools show: the polygon that is being drawn, and the frame for moving, turning and
// scaling.
#pragma once

#include <cstddef>
#include <vector>

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme);
void draw_frame_grips(const Painter& painter, const AppState& state, const Theme& theme);

// An edge and its index.
struct NumberedEdge {
  Vec2 a, b;
  std::size_t edge;
};
// The numbers of edges, on them and not over each other, as messages and settings count edges: from 1.
void draw_edge_numbers(const Painter& painter, const Theme& theme, Colour colour,
                       const std::vector<NumberedEdge>& edges);

}  // namespace evenlift::view
