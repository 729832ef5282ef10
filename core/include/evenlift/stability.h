// The lifting base H, its coverage, and the force that tips the object (algorithm.md, Terms and
// Stability; thesis 5.4).
#pragma once

#include <limits>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/hull.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/vec.h"

namespace evenlift {

// The lifting base H (robotics: support polygon): the convex hull of the lifting points, without
// corners that are due only to rounding (hull.h). O(m log m).
Points lifting_base(const Polygon& polygon, const std::vector<LiftingPoint>& points);

// The share of the object in H, in [0, 1]: area(A and H) / area(A), where A is the polygon minus
// its holes. It is 0 if H has no area. `hull` is H and must come from convex_hull. O(n h) for h
// corners; if n h is above 2^18, O(n log h + h) unless the outline winds about H.
double coverage(const PolygonWithHoles& object, const Points& hull);

// Computes the coverage of hulls within one outer hull. Clipping the object by the outer hull first
// often leaves few vertices.
class CoverageWithin {
 public:
  // `outer` must come from convex_hull and have an area. Costs as much as coverage().
  CoverageWithin(const PolygonWithHoles& object, const Points& outer);

  // Returns the same as coverage(), up to rounding, for a hull within the outer one. Costs as much,
  // for the n' vertices of the part of the object within the outer hull.
  double of(const Points& hull) const;

 private:
  Vec2 origin_;
  Points part_;  // relative to the origin
  double area_;  // of the object
};

// The least downward force at q that tips an object of this weight, if robots lift it at the
// corners of `hull`, push back and are not overloaded, and the weight acts anywhere within `reach`
// of C (tilt.h). The force is infinite if q is in H, unless the object tips without it. With two
// corners, as for a single team, the force is 0 if q is off their line, or if `reach` is above 0. If
// q is on the line beyond the end r, the force is `weight` |C r| / |q r|. With one corner it is 0
// everywhere. O(h).
double tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q,
                     double reach = 0);

}  // namespace evenlift
