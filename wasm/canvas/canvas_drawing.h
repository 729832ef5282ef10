// What the tools show: the polygon that is being drawn, and the frame for moving, turning and
// scaling.
#pragma once

#include "canvas/canvas_view.h"

namespace evenlift::view {

void draw_drawing(const Painter& painter, const AppState& state, const Theme& theme);
void draw_frame_grips(const Painter& painter, const AppState& state, const Theme& theme);

// The number of an edge at its middle, as messages count edges: from 1.
void draw_edge_number(const Painter& painter, const Theme& theme, const Vec2& a, const Vec2& b,
                      std::size_t edge);

// A text in a box at a spot, moved so that it is inside the window.
void draw_word(ImDrawList& list, const Vec2& spot, const Rect& window, const Theme& theme,
               Colour colour, const std::string& text);

}  // namespace evenlift::view
