// The area of the part of an object in a convex polygon with many corners.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Twice the area of the part of a closed ring in a convex, counter-clockwise polygon with an area,
// negative for a clockwise ring. Each edge is compared only with the sides of the polygon between
// the directions of its ends, seen from inside the polygon. So for a ring whose edges hardly
// overlap, seen from there, n edges and h sides take O(n log h + h); clipping takes O(n h) always.
double doubled_area_in_hull(const Points& ring, const Points& hull);

}  // namespace evenlift
