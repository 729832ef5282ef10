// Draws a robot as a disc with its number, or as a dot among very many robots.
#pragma once

#include <cstddef>
#include <vector>

#include "picture/canvas_view.h"

namespace evenlift::view {

// The radii of a robot's disc and ring, in pixels: smaller for many robots.
struct DiscSize {
  float disc, ring;
  bool numbered;
};
inline constexpr std::size_t most_labelled = 50;
DiscSize robot_size(std::size_t teams);

// The radius of a robot's disc with its ring, in pixels.
float mark_radius(const std::vector<Team>& teams);

// The distance from a robot, in pixels, to the outer end of its team's mark or, if robots have no
// numbers, to just outside its ring.
double mark_reach(const DiscSize& size);

// Draws the pale body of a robot without a size. The body is not to scale. Call this before any
// robot's disc is drawn.
void draw_small_body(const Painter& painter, const Theme& theme, const DiscSize& size,
                     const Vec2& world);

// The number of teams of two, or of teams that balanced robots would make: half the number of
// robots, rounded up.
std::size_t pairs_of(const std::vector<Team>& teams);

// The number of robots in the first `teams` teams of `all`.
std::size_t robots_of(const std::vector<Team>& all, std::size_t teams);

// The sizes of the robots in the first `teams` teams of `all`. A robot near another is smaller, and
// a robot very near another also has no number. O(m^2) for m robots; with more than most_labelled
// pairs, no distances are examined.
std::vector<DiscSize> robot_sizes(const CanvasView& view, const std::vector<Team>& all,
                                  std::size_t teams);

// A failed robot is hollow. The robots of a team of two have a common mark (evenlift::tally) on the
// side away from C.
struct RobotLook {
  std::size_t number = 1;
  std::size_t team = 0;  // from 1; 0 if it has no mark
  Vec2 outward;          // away from C, in polygon coordinates
  double share = 1;      // its load as a share of the greatest load
  bool over = false, failed = false;
  bool marked = false;   // its card is open, or it is pointed at
  bool beneath = false;  // stands beneath the object, and touches nothing sideways
};
void draw_robot(const Painter& painter, const Theme& theme, const DiscSize& size, const Vec2& world,
                const RobotLook& look);

// Draws thousands of robots as dots. Robots in the same spot share a dot, so that the window bounds
// the cost of a frame.
void draw_swarm(const Painter& painter, const CanvasView& view, std::size_t teams);

}  // namespace evenlift::view
