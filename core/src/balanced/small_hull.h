// The convex hull of a few robots, relative to C: in plain doubles and without memory, for the
// coverage of thousands of sets. A corner that only rounding makes changes nothing here.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift::balanced {

struct SmallHull {
  std::array<Vec2, most_robots> corners;  // counter-clockwise, relative to C
  std::size_t size = 0;                   // below 3 if the robots stand on one line
  double area = 0;
};

// Of at most most_robots robots. O(m^2) steps of insertion sort, of which few are taken.
SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre);

}  // namespace evenlift::balanced
