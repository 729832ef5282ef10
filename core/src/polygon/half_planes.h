// The intersection of half-planes, bounded or not, by exact predicates.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The half-plane of all q with (to - from) . q <= bound. Its normal is the exact difference of the
// two points.
struct HalfPlane {
  Vec2 from, to;
  double bound = 0;
  Vec2 normal() const { return to - from; }
};

// A gap between the directions of two consecutive normals, counter-clockwise from `before` to
// `after`.
struct NormalGap {
  std::size_t before = 0, after = 0;  // indices of the half-planes on its two sides
  int compare_to_half_turn = 0;       // -1, 0, 1: its width is below, equal to or above 180 degrees
};

// The widest gap between the normals of at least one half-plane. If all normals have the same
// direction, the gap is 360 degrees. If several gaps are 180 degrees or more, it is one of them. A
// gap narrower than 180 degrees counts as 180 if the sine of the difference is at most `sine`;
// otherwise the comparison is exact. O(m log m).
NormalGap widest_gap(const std::vector<HalfPlane>& planes, double sine);

// Whether some point lies in all closed half-planes. Exact for the given numbers. O(m log m).
bool have_common_point(const std::vector<HalfPlane>& planes);

// The corners of the intersection, counter-clockwise and rounded; none if it is empty. The
// intersection must be bounded: the normals leave no gap of 180 degrees or more. O(m log m).
Points bounded_intersection(const std::vector<HalfPlane>& planes);

}  // namespace evenlift
