// The stands of robots with a size, and the unusable parts of the boundary.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/report.h"
#include "marks/robots.h"
#include "picture/canvas_view.h"

namespace evenlift::view {

// Draws the unusable parts in grey, and no-go parts in amber. Call it only if robots have a size,
// or if there are no-go parts. O(parts).
void draw_unusable(const Painter& painter, const Placement& placement, const Theme& theme);

// All robots, if their bodies look at least as large as their discs; none otherwise, or for very
// many robots. O(robots).
std::vector<PlacedRobot> drawn_bodies(const CanvasView& view);

// Whether the robots have a size, which is then drawn to scale.
bool draws_sizes(const Placement& placement);

// Draws the unusable parts and, if robots have a size, their bodies, arms and hands to scale,
// beneath their marks. O(parts + robots).
void draw_stands(const Painter& painter, const CanvasView& view);

// The reason why no robot can stand at the hovered place of an edge; nullopt if a robot can stand
// there, or if the document is refused. O(log n).
std::optional<WhyUnusable> why_unusable(const AppState& state, const Pick& at);

// Writes that reason at the pointer.
void draw_why_unusable(const Painter& painter, const CanvasView& view);

// The labels of the loads, once all loads are known. Names keep clear of these labels
// (canvas_walkthrough.cpp).
std::vector<LoadLabel> loads_of_walkthrough(const CanvasView& view);

// Draws the robots placed up to the current step.
void draw_robots_of_walkthrough(const Painter& painter, const CanvasView& view);

}  // namespace evenlift::view
