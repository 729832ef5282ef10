// Rational Bézier curves of any degree up to 10, and their conversion to the pieces of outlines.
#pragma once

#include "curves/outline.h"
#include "evenlift/vec.h"

namespace evenlift {

// A control point (x, y) of weight w > 0, as (x w, y w, w).
using WeightedPoint = Vec3;

struct RationalBezier {
  std::size_t degree = 1;
  WeightedPoint points[max_spline_degree + 1];
};

// Appends the curve, which begins where the outline ends. Lines are exact. A conic is exact if its
// control point has a weight of at most 1 once its ends are given the weight 1. Any other curve is
// halved until each part is near its cubic, which has the same ends and the same derivatives there:
// no point of the part may be farther than `tolerance` (>= 0) from the cubic's point at the same
// parameter. Then the cubics are appended. A part that is still too far from its cubic after 10
// halvings becomes a line. Control points are relative to `origin`, which should be near them.
// Stops when the outline has more than `most` pieces. O(pieces degree^2).
void add_rational(Outline& outline, const RationalBezier& curve, const Vec2& origin,
                  double tolerance, std::size_t most);

}  // namespace evenlift
