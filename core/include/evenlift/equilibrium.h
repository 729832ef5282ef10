// Whether an object stands on its robots and, if it does not, over which robots it tips. C can be
// outside the lifting base H only if the places are given (supports.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct Equilibrium {
  bool stands = false;  // whether C is in H, within tau L; false without robots
  // The tipping distance (uncertainty.h) or, if the object falls, minus the distance of C from H.
  double com_margin = 0;
  // If the object falls, the numbers of the two robots at the ends of the edge of H beyond which C
  // lies farthest, in ascending order. There is only one number if H is a point, or if H is a
  // segment and C lies on the line of H beyond that robot.
  std::vector<std::uint32_t> tips_over;
};

// Finds whether the object stands. `robots` are positions in the order of the robots' numbers;
// `diameter` is L. O(m log m).
Equilibrium analyse_equilibrium(const Points& robots, const Vec2& centre, double diameter);

}  // namespace evenlift
