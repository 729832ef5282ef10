// The stands of robots with a size, and the unusable parts of the boundary.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// Draws the unusable parts in grey, no-go parts in amber. There must be robots with a size, or
// no-go parts. O(parts).
void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme);

// The robots whose body is drawn, because it is larger than the mark; empty for very many robots.
// O(robots).
std::vector<PlacedRobot> drawn_bodies(const CanvasView& view);

// Whether the robots have a size, drawn to scale.
bool draws_sizes(const Placement& placement);

// Draws the unusable parts and, if robots have a size, their bodies, arms and hands to scale,
// beneath their marks. O(parts + robots).
void draw_stands(const Painter& painter, const CanvasView& view);

// The reason why no robot can stand at the hovered place of an edge; nullopt if one can, or if the
// placement is not the document's. O(log n).
std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at);

// Writes that reason at the pointer.
void draw_why_unusable(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
