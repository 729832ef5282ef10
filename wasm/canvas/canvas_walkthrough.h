#pragma once

#include "picture/canvas_view.h"

namespace evenlift::view {

void draw_figure(const Painter& painter, const CanvasView& view, const Figure& figure);

// Draws a ring around a place, to mark it for a step or for a question.
void draw_ring(const Painter& painter, const Vec2& at, Colour colour);

// Draws the point M of the search for balanced robots, with its name.
void draw_middle(const Painter& painter, const CanvasView& view, const Vec2& world);

// --- Draws a step of the walkthrough: everything known after the step and, on top, its figures.

void draw_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
