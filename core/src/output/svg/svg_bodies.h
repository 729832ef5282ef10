// Robots with a size in a picture: the unusable boundary, and the robots to scale.
#pragma once

#include <string>
#include <vector>

#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"
#include "evenlift/plane.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// The robots, team after team, if they have a size; otherwise empty. O(n + robots).
std::vector<PlacedRobot> robots_with_size(const Placement& placement);

// The points that must fit on the paper: the vertices, the outlines of these robots' bodies and the
// discs of cargo. O(n + robots + items).
Points extent(const Placement& placement, const std::vector<PlacedRobot>& robots);

// Empty for points that may stand anywhere. O(parts).
std::string unusable_boundary(const Placement& placement, const Paper& paper);

// The robots with a size. O(robots).
std::string bodies(const std::vector<PlacedRobot>& robots, const RobotSize& size,
                   const Paper& paper);

// The box of a robot's body, in pixels. O(1).
Box body_box(const PlacedRobot& robot, const RobotSize& size, const Paper& paper);

}  // namespace evenlift::svg
