// Draws the unusable boundary, and robots to scale.
#pragma once

#include <string>
#include <vector>

#include "evenlift/plane.h"
#include "evenlift/report.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// The robots of all teams in turn; empty if the robots have no size. O(n + robots).
std::vector<PlacedRobot> robots_with_size(const Placement& placement);

// Points that must fit on the paper: the vertices, and corners of the boxes around these robots'
// bodies and the discs of cargo. O(n + robots + items).
Points extent(const Placement& placement, const std::vector<PlacedRobot>& robots);

// Draws the unusable boundary; empty if robots may stand anywhere. O(parts).
std::string unusable_boundary(const Placement& placement, const Paper& paper);

// Draws the robots to scale. O(robots).
std::string bodies(const std::vector<PlacedRobot>& robots, const RobotSize& size,
                   const Paper& paper);

// The box around the robot's body, in pixels. O(1).
Box body_box(const PlacedRobot& robot, const RobotSize& size, const Paper& paper);

}  // namespace evenlift::svg
