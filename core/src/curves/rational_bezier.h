// Rational Bézier curves of any degree up to 10, and their conversion to the pieces of outlines.
#pragma once

#include "curves/outline.h"

namespace evenlift {

// The coordinates of a control point times its weight (above 0), and then the weight.
using WeightedPoint = Eigen::Vector3d;

struct RationalBezier {
  std::size_t degree = 1;
  WeightedPoint points[max_spline_degree + 1];
};

// Appends the curve, which begins where the outline ends. Lines and conics with a weight of at most
// 1 are exact. Any other curve is halved until each part is near the cubic with the same ends and
// the same derivatives there: no point may be farther than `tolerance` (>= 0) from the cubic's
// point at the same parameter. These cubics are appended; a part that is still farther away after
// 10 halvings becomes a line. Control points are relative to `origin`, which should be near them.
// Stops when the outline has more than `most` pieces. O(pieces degree^2).
void add_rational(Outline& outline, const RationalBezier& curve, const Vec2& origin,
                  double tolerance, std::size_t most);

}  // namespace evenlift
