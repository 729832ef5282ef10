// The size to which the tolerance refers where robots are far from the origin.
#pragma once

#include <algorithm>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// L; or more if the coordinates are so large that rounding them moves a robot by more than tau L,
// as with an object of 10 at 1e9. Two robots of a team and C are then on one line only within that
// rounding, and tau times this size allows for it. O(m).
inline double known_size(const Points& robots, const Vec2& centre, double diameter) {
  double reach = centre.cwiseAbs().maxCoeff();
  for (const Vec2& robot : robots) reach = std::max(reach, robot.cwiseAbs().maxCoeff());
  return std::max(diameter, 0x1p-51 * reach / tau);
}

}  // namespace evenlift
