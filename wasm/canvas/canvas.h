// The canvas: its pictures, the line at its foot, and steps of the walkthrough.
#pragma once

#include <string>

#include "picture/canvas_view.h"
#include "picture/painter.h"
#include "picture/scene.h"
#include "state/layout.h"
#include "state/state.h"

namespace evenlift::view {

// Writes a name such as "edge 4" or "vertex 1" beside each part that the step shows, on the outside
// of the polygon, and "C" beside the centre of mass. All names keep clear of occupied places.
// O(vertices) for each name.
void draw_part_names(const Painter& painter, const CanvasView& view, Occupied& occupied);

// --- The line at the foot of the canvas, which names the part under the pointer and its uses.

// Empty if there is no hint.
std::string hint(const AppState& state);

// The hint as the canvas shows it: the last phrases are left out if they have no room beside the
// view tools. Empty if no phrase has room. Also empty if the screen is narrow, low or used with
// fingers, or while a notice, a card or a window of the page is open.
std::string shown_hint(const AppState& state, const Layout& layout);

void draw_hint(ImDrawList& list, const AppState& state, const Layout& layout, const Theme& theme);

void draw_figure(const Painter& painter, const CanvasView& view, const Figure& figure);

// Draws a ring around a place, to mark it for a step or for a question.
void draw_ring(const Painter& painter, const Vec2& at, Colour colour);

// Draws the point M of the search for balanced robots, with its name.
void draw_middle(const Painter& painter, const CanvasView& view, const Vec2& world);

// --- Draws a step of the walkthrough: everything known after the step and, on top, its figures.

void draw_walkthrough(const Painter& painter, const CanvasView& view);

// --- The canvas: the background, and the pictures with their numbers and grips.

// Draws into Dear ImGui's background, under every panel. `second` is the scene of the second
// method.
void draw_canvas(const AppState& state, const Scene& scene, const Scene& second,
                 const Layout& layout);

}  // namespace evenlift::view
