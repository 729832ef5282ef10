// The convex hull of a few robots, relative to C. It is computed in plain doubles and without
// allocation, since the search computes the coverage of thousands of sets. Corners due only to
// rounding do not matter.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift::balanced {

struct SmallHull {
  std::array<Vec2, most_robots> corners;  // counter-clockwise
  std::size_t size = 0;                   // less than 3 if the robots stand on one line
  double area = 0;
};

// The hull of at most most_robots robots. O(m^2) by insertion sort, in practice few steps.
SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre);

}  // namespace evenlift::balanced
