// The convex hull of a few robots, relative to C. It is computed in plain doubles and without
// allocation, since the search computes the coverage of thousands of sets. The hull may have
// corners that exist only through rounding; they hardly change its area.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift::balanced {

struct SmallHull {
  std::array<Vec2, most_robots> corners;  // counter-clockwise
  std::size_t size = 0;                   // less than 3 if all robots are on one line
  double area = 0;
};

// Returns the hull of at most most_robots robots. O(m^2), by an insertion sort that usually takes
// few steps.
SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre);

}  // namespace evenlift::balanced
