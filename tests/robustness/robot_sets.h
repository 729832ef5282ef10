// Sets of robots about a centre of mass, mostly hard: robots collinear, at one place, in pairs
// across C; C at a robot, on the edge of H or outside; tiny, huge and far away.
#pragma once

#include <cstdint>
#include <string>

#include "evenlift/vec.h"

namespace robot_sets {

struct RobotSet {
  std::string kind;
  evenlift::Points robots;
  evenlift::Vec2 centre;
  double diameter = 0;  // L: of the robots and C, in place of an object
};

// With 1 to `most` robots; the kinds alternate. The same on every platform.
RobotSet make_set(std::uint64_t number, std::size_t most);

// Up to `most` robots with small whole coordinates, and C at the origin, so that collinearity is
// exact.
RobotSet make_grid(std::uint64_t number, std::size_t most);

// Teams of two across C, of various lengths; each robot is rounded separately.
RobotSet make_pairs(std::uint64_t number, std::size_t teams);

// At least three robots, not collinear, with C well inside.
RobotSet make_steady_set(std::uint64_t number, std::size_t most);

// Of many shapes, some thin, with C at 1e-1 to 1e-9 L from an edge of H.
RobotSet make_near_edge(std::uint64_t number, std::size_t most);

// Perhaps mirrored, then turned, scaled and moved; each step rounds.
RobotSet moved(const RobotSet& set, std::uint64_t number);

}  // namespace robot_sets
