// Intersections of half-planes; areas and centroids of rings.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// --- Finds the intersection of half-planes, which may be unbounded, by exact predicates.

// All points q with (to - from) . q <= bound. Predicates use the exact difference of `to` and
// `from`, which normal() rounds.
struct HalfPlane {
  Vec2 from, to;
  double bound = 0;
  Vec2 normal() const { return to - from; }
};

// The angle between two consecutive normals, counter-clockwise from `before` to `after`.
struct NormalGap {
  std::size_t before = 0, after = 0;  // the half-planes' indices
  int compare_to_half_turn = 0;       // -1, 0, 1: below, equal to or above 180 degrees
};

// The gap above 180 degrees between the normals of one or more half-planes; 360 degrees if all
// normals have the same direction. Without such a gap, returns one that counts as 180 degrees, or
// else any gap. A gap below 180 degrees counts as 180 if the sine of the difference is at most
// `sine`; otherwise the comparison is exact. O(m log m).
NormalGap widest_gap(const std::vector<HalfPlane>& planes, double sine);

// Whether all the closed half-planes have a point in common. The answer is exact for the given
// numbers. O(m log m).
bool have_common_point(const std::vector<HalfPlane>& planes);

// The corners of the intersection, rounded to doubles, counter-clockwise; none if it is empty.
// The intersection must be bounded: no gap between normals is 180 degrees or more. O(m log m).
Points bounded_intersection(const std::vector<HalfPlane>& planes);

// --- The area and centroid of a ring.

struct Moments {
  double area;  // above 0
  Vec2 centroid;
};

// Returns the area and the centroid's coordinates, each rounded to the nearest double. The ring may
// run along a line there and back, as in polygons with holes (polygon_with_holes.h). `corner` is
// the lower left corner of the ring's bounding box. The area must not be 0. O(n).
Moments moments(const Points& vertices, const Vec2& corner);

}  // namespace evenlift
