// The stands of robots with a size, and the unusable parts of the boundary.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// Grey, or amber for no-go parts. For robots with a size, or with no-go parts. O(parts).
void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme);

// The robots whose body is drawn, because it is larger than the mark; empty for very many robots.
// O(robots).
std::vector<PlacedRobot> drawn_bodies(const CanvasView& view);

// Whether the robots have a size, drawn to scale.
bool draws_sizes(const Placement& placement);

// The unusable parts, then the robots' bodies, arms and hands to scale, beneath their marks. Bodies
// need a size. O(parts + robots).
void draw_stands(const Painter& painter, const CanvasView& view);

// Why no robot can stand at the hovered place of an edge; nothing if one can, or if the placement
// is not the document's. O(log n).
std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at);

// At the pointer.
void draw_why_unusable(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
