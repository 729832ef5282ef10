// The size for the tolerance of robots far from the origin.
#pragma once

#include <algorithm>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// L, or more if rounding of large coordinates moves a robot by more than tau L, as for an object of
// size 10 at 1e9. Then two robots of a team and C are collinear only up to that rounding, which tau
// times this size allows for. O(m).
inline double known_size(const Points& robots, const Vec2& centre, double diameter) {
  double reach = centre.cwiseAbs().maxCoeff();
  for (const Vec2& robot : robots) reach = std::max(reach, robot.cwiseAbs().maxCoeff());
  return std::max(diameter, 0x1p-51 * reach / tau);
}

}  // namespace evenlift
