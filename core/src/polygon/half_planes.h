// The intersection of half-planes, whether bounded or not, by exact predicates.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// All q with (to - from) . q <= bound. The normal is the exact difference of the two points.
struct HalfPlane {
  Vec2 from, to;
  double bound = 0;
  Vec2 normal() const { return to - from; }
};

// The widest range of directions between neighbouring normals, seen counter-clockwise.
struct NormalGap {
  std::size_t before = 0, after = 0;  // indices of the half-planes on its two sides
  int excess = 0;                     // sign of its width minus 180 degrees
};

// The widest gap between the normals of at least one half-plane. If all normals share one
// direction, the gap is the full turn; if several gaps are 180 degrees or more, it is one of them.
// A gap counts as 180 degrees if the sine of what it is short of them is at most `sine`; signs are
// exact otherwise. O(m log m).
NormalGap widest_gap(const std::vector<HalfPlane>& planes, double sine);

// Whether some point lies in all closed half-planes; exact for the given numbers. O(m log m).
bool have_common_point(const std::vector<HalfPlane>& planes);

// Corners of the intersection, counter-clockwise, rounded; only for normals without a gap of 180
// degrees or more (the intersection is bounded), and empty if the intersection is. O(m log m).
Points bounded_intersection(const std::vector<HalfPlane>& planes);

}  // namespace evenlift
