// An order of points that does not depend on their source.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Whether a precedes b by x, then by y.
inline bool is_before(const Vec2& a, const Vec2& b) {
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

}  // namespace evenlift
