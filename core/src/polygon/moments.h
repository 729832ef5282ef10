// The area and centroid of a ring.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct Moments {
  double area;  // above 0
  Vec2 centroid;
};

// Returns the area and the centroid's coordinates, each rounded to the nearest double. The ring may
// run along a line there and back, as in polygons with holes (polygon_with_holes.h). `corner` is
// the lower left corner of the ring's bounding box. The area must not be 0. O(n).
Moments moments(const Points& ring, const Vec2& corner);

}  // namespace evenlift
