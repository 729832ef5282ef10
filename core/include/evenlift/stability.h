// Coverage and the force that tips (algorithm.md, Terms and Stability; thesis 5.4).
#pragma once

#include <limits>

#include "evenlift/hull.h"
#include "evenlift/polygon.h"
#include "evenlift/vec.h"

namespace evenlift {

// The part of the polygon that lies in H, area(P and H) / area(P), in [0, 1]; 0 if H has no area.
// `hull` must come from convex_hull. O(n h) for h corners.
double coverage(const Polygon& polygon, const Points& hull);

// The smallest downward force at q that tips an object of weight `weight`, carried at the corners
// of `hull`; infinity if q is in H, where no force tips it. With two corners, as of a single team,
// it is 0 off the line through both; on the line beyond the end r it is weight |C r| / |q r|. O(h).
double tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q);

}  // namespace evenlift
