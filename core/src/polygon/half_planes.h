// The intersection of half-planes, perhaps unbounded, by exact predicates.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// All q with (to - from) . q <= bound. The normal is the exact difference of the points.
struct HalfPlane {
  Vec2 from, to;
  double bound = 0;
  Vec2 normal() const { return to - from; }
};

// Between two consecutive normals, counter-clockwise from `before` to `after`.
struct NormalGap {
  std::size_t before = 0, after = 0;  // the half-planes' indices
  int compare_to_half_turn = 0;       // -1, 0, 1: below, equal to or above 180 degrees
};

// Between the normals of one or more half-planes; 360 degrees if all have the same direction. If
// several gaps are 180 degrees or more, it is one of them. A narrower gap counts as 180 if the sine
// of the difference is at most `sine`; otherwise the comparison is exact. O(m log m).
NormalGap widest_gap(const std::vector<HalfPlane>& planes, double sine);

// In all closed half-planes. Exact for the given numbers. O(m log m).
bool have_common_point(const std::vector<HalfPlane>& planes);

// The corners, counter-clockwise and rounded; none if the intersection is empty. It must be
// bounded: no gap of 180 degrees or more between normals. O(m log m).
Points bounded_intersection(const std::vector<HalfPlane>& planes);

}  // namespace evenlift
