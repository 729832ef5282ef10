// An order of points that depends only on their coordinates.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Whether a comes before b in order of x, then of y.
inline bool is_before(const Vec2& a, const Vec2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

}  // namespace evenlift
