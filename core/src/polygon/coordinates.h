// The least size of coordinates.
#pragma once

#include <cmath>

#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// Differences of accepted coordinates are at least 1e-116: lengths, areas and moments of even the
// thinnest object stay far from underflow. O(1).
inline bool is_too_near_to_0(double coordinate) {
  return coordinate != 0 && std::fabs(coordinate) < min_coordinate;
}
inline bool is_too_near_to_0(const Vec2& v) {
  return is_too_near_to_0(v.x()) || is_too_near_to_0(v.y());
}

}  // namespace evenlift
