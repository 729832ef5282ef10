// The convex hull of a few robots, relative to C: in plain doubles and without allocating memory,
// for the coverage of thousands of sets. A corner that results only from rounding does not matter
// here.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift::balanced {

struct SmallHull {
  std::array<Vec2, most_robots> corners;  // counter-clockwise, relative to C
  std::size_t size = 0;                   // less than 3 if the robots stand on one line
  double area = 0;
};

// For at most most_robots robots. Insertion sort takes O(m^2) steps, in practice few.
SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre);

}  // namespace evenlift::balanced
