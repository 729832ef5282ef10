// A robot as a disc with its number, or as a dot among very many.
#pragma once

#include <cstddef>
#include <vector>

#include "picture/canvas_view.h"

namespace evenlift::view {

// Smaller for many robots.
struct RobotSize {
  float disc, ring;
  bool numbered;
};
inline constexpr std::size_t most_labelled = 50;
RobotSize robot_size(std::size_t teams);

// In pixels.
float mark_radius(const std::vector<Team>& teams);

// From a robot to the end of all that is drawn around it: its body and its team's mark.
double mark_reach(const RobotSize& size);

// The pale body of a robot without a size: not to scale, and beneath the discs of all robots.
void draw_small_body(const Painter& painter, const Theme& theme, const RobotSize& size,
                     const Vec2& world);

// The number of teams of two, or of those that the balanced robots would make.
std::size_t pairs_of(const std::vector<Team>& teams);

// In the first `teams` of the teams.
std::size_t robots_of(const std::vector<Team>& all, std::size_t teams);

// Near another robot, one is smaller, and has no number if that would touch the other. O(m^2) for m
// robots, of which at most most_labelled pairs are examined.
std::vector<RobotSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                   std::size_t teams);

// A failed robot is hollow. The robots of a team of two have a common mark (evenlift::tally) on the
// side away from C.
struct RobotLook {
  std::size_t number = 1;
  std::size_t team = 0;         // from 1; 0 without a mark
  Vec2 outward = Vec2::Zero();  // away from C, in polygon coordinates
  double share = 1;             // of the greatest load
  bool over = false, failed = false;
  bool marked = false;   // its card is open, or it is pointed at
  bool beneath = false;  // stands beneath the object, and touches nothing sideways
};
void draw_robot(const Painter& painter, const Theme& theme, const RobotSize& size,
                const Vec2& world, const RobotLook& look);

// Thousands of robots as dots, with one for all in the same spot: the window bounds the cost of a
// frame.
void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams);

}  // namespace evenlift::view
