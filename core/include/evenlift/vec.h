// Points and vectors of the plane. Convention everywhere: x to the right, y up, angles and
// polygon orientation counter-clockwise positive. Units are those of the input.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace evenlift {

using Vec2 = Eigen::Vector2d;
using Points = std::vector<Vec2>;

// Cross product a.x b.y - a.y b.x: positive when b points to the left of a. Plain doubles; a
// decision about input coordinates takes predicates.h instead. O(1).
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// Dot product. O(1).
inline double dot(const Vec2& a, const Vec2& b) { return a.x() * b.x() + a.y() * b.y(); }

// Length by one square root (not hypot, which differs between libraries). O(1).
inline double length(const Vec2& a) { return std::sqrt(a.x() * a.x() + a.y() * a.y()); }

// a turned by +90 degrees: the left normal of a. O(1).
inline Vec2 left_normal(const Vec2& a) { return {-a.y(), a.x()}; }

}  // namespace evenlift
