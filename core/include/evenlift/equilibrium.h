// Whether an object stands on its robots, and over which of them it tips if not. If a method finds
// the places, C is always in the lifting base H; if the places are given (supports.h), C can be
// outside.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct Equilibrium {
  bool stands = false;  // C is in H, within tolerance (tau L); false without robots
  // If it stands, the tipping distance (uncertainty.h); if not, minus the distance of C from H.
  double com_margin = 0;
  // If it falls, the numbers of the two robots at the ends of one edge of H, in ascending order:
  // the edge that C lies beyond by the greatest distance. There is only one robot if H is a point,
  // or if H is a segment and C lies on its line beyond that robot.
  std::vector<std::uint32_t> tips_over;
};

// `robots` are the positions of the robots in the order of their numbers; `diameter` is L of the
// object. O(m log m).
Equilibrium analyse_equilibrium(const Points& robots, const Vec2& centre, double diameter);

}  // namespace evenlift
