// Whether an object stands on its robots, or over which it tips. C can be outside the lifting base
// H only if the places are given (supports.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct Equilibrium {
  bool stands = false;  // C is in H, within tau L; false without robots
  // The tipping distance (uncertainty.h) or, if the object falls, minus the distance of C from H.
  double com_margin = 0;
  // If it falls, the numbers of the two robots, in ascending order, at the ends of the edge of H
  // that C lies beyond by the greatest distance; only one if H is a point, or a segment on whose
  // line C lies beyond that robot.
  std::vector<std::uint32_t> tips_over;
};

// `robots` are positions in the order of the robots' numbers; `diameter` is L. O(m log m).
Equilibrium analyse_equilibrium(const Points& robots, const Vec2& centre, double diameter);

}  // namespace evenlift
