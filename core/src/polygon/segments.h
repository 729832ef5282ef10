// Distances of line segments.
#pragma once

#include <algorithm>

#include "evenlift/vec.h"

namespace evenlift {

// The distance of p from the segment a b, which may be a point. O(1).
inline double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  const double part = square > 0 ? std::clamp(dot(p - a, along) / square, 0.0, 1.0) : 0;
  return length(p - (a + part * along));
}

}  // namespace evenlift
