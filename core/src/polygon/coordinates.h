// The least size of coordinates.
#pragma once

#include <cmath>

#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// Whether a coordinate is not 0 but nearer to 0 than is accepted. Differences of accepted
// coordinates are 0 or at least 1e-116 in size, so lengths, areas and moments of even the thinnest
// object stay far from underflow. O(1).
inline bool is_too_near_to_0(double coordinate) {
  return coordinate != 0 && std::fabs(coordinate) < min_coordinate;
}
inline bool is_too_near_to_0(const Vec2& v) {
  return is_too_near_to_0(v.x) || is_too_near_to_0(v.y);
}

}  // namespace evenlift
