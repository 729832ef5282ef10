// The area and the centroid within a closed line.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

struct Moments {
  double area;  // above 0
  Vec2 centroid;
};

// The area and the centroid within a ring, each rounded to the nearest doubles. The ring may run
// along a line there and back, as those of polygons with holes do (polygon_with_holes.h). `corner`
// is the lower left corner of its bounding box. Its area must not be 0. O(n).
Moments moments(const Points& ring, const Vec2& corner);

}  // namespace evenlift
