// The tools' drawings: the polygon being drawn, and the frame for moving, turning and scaling.
#pragma once

#include <cstddef>
#include <vector>

#include "picture/canvas_view.h"

namespace evenlift::view {

// Words stay within `free`.
void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme,
                  const Rect& free);
void draw_frame_grips(const Painter& painter, const CanvasView& view);

struct NumberedEdge {
  Vec2 a, b;
  std::size_t edge;
};
// Draws the numbers of edges, from 1, as in messages and settings. If an edge has room, its number
// covers neither an earlier number nor one of the boxes `before`, which are in pixels.
void draw_edge_numbers(const Painter& painter, const Theme& theme, Colour colour,
                       const std::vector<NumberedEdge>& edges, std::vector<Rect> before = {});

// --- Draws everything of a fixed size on a picture: grips, robots, the centre of mass, numbers.

void draw_marks(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
