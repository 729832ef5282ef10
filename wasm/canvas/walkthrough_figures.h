#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_figure(const Painter& painter, const CanvasView& view, const Figure& figure);

// Draws a ring around a place, to mark it for a step or for a question.
void draw_ring(const Painter& painter, const Vec2& at, Colour colour);

// Draws the point M of the search for balanced robots, with its name.
void draw_middle(const Painter& painter, const CanvasView& view, const Vec2& world);

}  // namespace evenlift::view
