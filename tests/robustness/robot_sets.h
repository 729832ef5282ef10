// Sets of robots about a centre of mass, with an emphasis on hard cases: robots collinear, at one
// place, in pairs across C, C at a robot, on the edge of H or outside it; tiny, huge and far away.
#pragma once

#include <cstdint>
#include <string>

#include "evenlift/vec.h"

namespace robot_sets {

struct RobotSet {
  std::string kind;
  evenlift::Points robots;
  evenlift::Vec2 centre = evenlift::Vec2::Zero();
  double diameter = 0;  // L: of the robots and C, which here represent the object
};

// The set of that number, with 1 to `most` robots; the kinds alternate. The same on every platform.
RobotSet make_set(std::uint64_t number, std::size_t most);

// Up to `most` robots with small whole coordinates, and C at the origin, so that collinear robots
// are exactly collinear.
RobotSet make_grid(std::uint64_t number, std::size_t most);

// Teams of two across C, of various lengths; a robot and its partner are rounded separately.
RobotSet make_pairs(std::uint64_t number, std::size_t teams);

// A set of at least three robots that are not collinear, with C well inside.
RobotSet make_steady_set(std::uint64_t number, std::size_t most);

// A set of many shapes, including thin ones, and C at a distance of 1e-1 to 1e-9 L from an edge of
// H.
RobotSet make_near_edge(std::uint64_t number, std::size_t most);

// The set optionally mirrored, then turned, scaled and moved; each step rounds.
RobotSet moved(const RobotSet& set, std::uint64_t number);

}  // namespace robot_sets
