// Where robots of a size stand, and what of the boundary they cannot use.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// What of the boundary cannot be used: grey, or amber where it was marked. For placements of robots
// with a size, or with marks. O(parts).
void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme);

// The robots whose bodies are drawn, since they are larger than a robot's mark; none of very many.
// O(robots).
std::vector<PlacedRobot> drawn_bodies(const CanvasView& view);

// What of the boundary cannot be used, grey, or amber where it was marked; then the bodies, arms
// and hands of the robots to scale, beneath their marks. Without a size nothing. O(parts + robots).
void draw_stands(const Painter& painter, const CanvasView& view);

// Why nobody can stand at the place of an edge that is pointed at; nothing where somebody can, or
// where the placement is not that of the document. O(log n).
std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at);

// Writes that reason at the pointer.
void draw_why_unusable(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
