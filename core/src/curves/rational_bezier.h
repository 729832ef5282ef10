// Rational Bézier curves of any degree up to 10, and their conversion to the pieces of outlines.
#pragma once

#include "curves/outline.h"

namespace evenlift {

// A control point times its weight (above 0), and the weight.
using WeightedPoint = Eigen::Vector3d;

struct RationalBezier {
  std::size_t degree = 1;
  WeightedPoint points[max_spline_degree + 1];
};

// Appends the curve, which begins where the outline ends. Lines and conics with a weight of at most
// 1 are exact. Any other curve becomes cubics: it is halved until no point is farther than
// `tolerance` (>= 0) from that of the cubic with the same ends and tangents; what is still farther
// after 10 halvings becomes a line. Control points are relative to `origin`, which should be near.
// Stops when the outline has more than `most` pieces. O(pieces degree^2).
void add_rational(Outline& outline, const RationalBezier& curve, const Vec2& origin,
                  double tolerance, std::size_t most);

}  // namespace evenlift
