// Converts directions in degrees to vectors.
#pragma once

#include <cmath>

#include "evenlift/angles.h"
#include "evenlift/vec.h"

namespace evenlift {

// The unit vector at this angle, counter-clockwise from the x axis. It is exact for multiples of 90
// degrees, so a block that is turned by such an angle keeps its right angles. O(1).
inline Vec2 direction_of(double degrees) {
  const double turn = std::fmod(degrees, 360);
  const double quarters = std::floor(turn / 90 + 0.5);
  const double rest = (turn - 90 * quarters) * (pi / 180);
  Vec2 direction = rest == 0 ? Vec2(1, 0) : Vec2(cosine(rest), sine(rest));
  for (int i = static_cast<int>(quarters) & 3; i > 0; --i) direction = left_normal(direction);
  return direction;
}

}  // namespace evenlift
