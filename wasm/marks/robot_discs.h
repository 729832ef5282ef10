// A robot as a disc with its number, or as a dot where there are very many.
#pragma once

#include <cstddef>
#include <vector>

#include "picture/canvas_view.h"

namespace evenlift::view {

// With many robots their marks are smaller.
struct RobotSize {
  float disc, ring;
  bool numbered;
};
inline constexpr std::size_t most_labelled = 50;
RobotSize robot_size(std::size_t teams);

// How far the mark of a robot reaches, in pixels.
float mark_radius(const std::vector<Team>& teams);

// How many teams of two there are, or would be of so many balanced robots.
std::size_t pairs_of(const std::vector<Team>& teams);

// The number of robots in the first of the teams.
std::size_t robots_of(const std::vector<Team>& all, std::size_t teams);

// The size of each robot: one that stands near to another is smaller, and has no number where that
// would touch the other. O(m^2) for m robots, of which only up to most_labelled pairs are looked
// at.
std::vector<RobotSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                   std::size_t teams);

// How a robot is drawn besides its size; one that fails is hollow.
struct RobotLook {
  std::size_t number = 1;
  double share = 1;  // of the greatest load
  bool over = false, failed = false;
  bool explained = false;  // its card is open
};
void draw_robot(const Painter& painter, const Theme& theme, const RobotSize& size,
                const Vec2& world, const RobotLook& look);

// Thousands of robots are dots, and one dot is drawn for all of them in the same spot, so that the
// window bounds what a frame draws.
void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams);

}  // namespace evenlift::view
