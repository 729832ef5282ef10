// The size on which the tolerance for robots far from the origin is based.
#pragma once

#include <algorithm>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// Returns L, or more if rounding of large coordinates moves a robot by more than tau L, as for an
// object of size 10 at coordinates of 1e9. In that case the two robots of a team and C are
// collinear only up to this rounding, and tau times the returned size allows for it. O(m).
inline double known_size(const Points& robots, const Vec2& centre, double diameter) {
  double reach = max_norm(centre);
  for (const Vec2& robot : robots) reach = std::max(reach, max_norm(robot));
  return std::max(diameter, 0x1p-51 * reach / tau);
}

}  // namespace evenlift
