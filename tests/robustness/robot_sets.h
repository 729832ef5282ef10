// Sets of robots about a centre of mass, with a liking for what is hard: robots on one line, at one
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
  double diameter = 0;  // L: of the robots and C, which here stand for the object
};

// The set of that number, with 1 to `most` robots; the kinds take turns. The same on every
// platform.
RobotSet make_set(std::uint64_t number, std::size_t most);

// Up to `most` robots with small whole coordinates, and C at the origin: so whatever is on one line
// is so exactly.
RobotSet make_grid(std::uint64_t number, std::size_t most);

// Teams of two across C, of lengths as they come; a robot and its partner are rounded apart.
RobotSet make_pairs(std::uint64_t number, std::size_t teams);

// A set of at least three robots that do not stand on one line, with C well inside.
RobotSet make_steady_set(std::uint64_t number, std::size_t most);

// A set of many shapes, thin ones too, and C at a distance of 1e-1 to 1e-9 L from an edge of H.
RobotSet make_near_edge(std::uint64_t number, std::size_t most);

// The set mirrored or not, turned, scaled and moved; each step rounds.
RobotSet moved(const RobotSet& set, std::uint64_t number);

}  // namespace robot_sets
