// Robust predicates: determinants of input coordinates, with exact signs. They are adaptive (J. R.
// Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates,
// 1997; algorithm.md, Exact or within τ). Doubles with an error bound nearly always decide the
// sign; otherwise double-double arithmetic decides it or, as a last resort, exact integers.
//
// The result is 0 only if the determinant is 0, and its relative error is below 2^-45. Arguments
// must be finite. O(1), usually a few multiplications; exact integers are about 100 times slower.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// (b - a) x (c - a), twice the signed area of the triangle: positive if a, b, c turn left.
double orient(const Vec2& a, const Vec2& b, const Vec2& c);

// (a1 - a0) x (b1 - b0): positive if the second vector points to the left of the first.
double cross_of_differences(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1);

// (a1 - a0) . (b1 - b0)
double dot_of_differences(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1);

// (b - w') x (c - b), where w' = 2 centre - w mirrors w: positive if w', b, c turn left, and 0 if
// w' lies on the line through b and c.
double orient_mirrored(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c);

}  // namespace evenlift
