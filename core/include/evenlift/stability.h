// Coverage and the force that tips (algorithm.md, Terms and Stability; thesis 5.4).
#pragma once

#include <limits>

#include "evenlift/hull.h"
#include "evenlift/polygon.h"
#include "evenlift/vec.h"

namespace evenlift {

// area(P and H) / area(P) in [0, 1]; 0 while H has no area. `hull` as convex_hull gives it.
// O(n h) for h corners.
double coverage(const Polygon& polygon, const Points& hull);

// The smallest downward force at q that tips an object of weight `weight` carried at the corners
// of `hull`; infinity where no force does (q in H). With two corners (a single team): 0 off
// their line, beyond an end r the force weight |C r| / |q r|. O(h).
double tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q);

}  // namespace evenlift
