// The size to which the tolerance refers when robots are far from the origin.
#pragma once

#include <algorithm>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// L; or more if the coordinates are so large that rounding moves a robot by more than tau L, as
// with an object of size 10 at 1e9. Then two robots of a team and C are collinear only up to that
// rounding, and tau times this size allows for it. O(m).
inline double known_size(const Points& robots, const Vec2& centre, double diameter) {
  double reach = centre.cwiseAbs().maxCoeff();
  for (const Vec2& robot : robots) reach = std::max(reach, robot.cwiseAbs().maxCoeff());
  return std::max(diameter, 0x1p-51 * reach / tau);
}

}  // namespace evenlift
