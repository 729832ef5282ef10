// Points and vectors of the plane. The x axis points right and the y axis up; counter-clockwise
// angles and orientations are positive. Coordinates are in the units of the input.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <vector>

namespace evenlift {

using Vec2 = Eigen::Vector2d;
using Points = std::vector<Vec2>;

// a.x b.y - a.y b.x, which is positive if `b` points to the left of `a`. The result is rounded; for
// exact decisions about input coordinates use predicates.h. O(1).
inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// The scalar product. O(1).
inline double dot(const Vec2& a, const Vec2& b) { return a.x() * b.x() + a.y() * b.y(); }

// The length. It is computed with a square root, since hypot differs between libraries. O(1).
inline double length(const Vec2& a) { return std::sqrt(a.x() * a.x() + a.y() * a.y()); }

// |a.x| + |a.y|, which is never below the length. O(1).
inline double one_norm(const Vec2& a) { return std::fabs(a.x()) + std::fabs(a.y()); }

// The vector `a`, turned by +90 degrees. O(1).
inline Vec2 left_normal(const Vec2& a) { return {-a.y(), a.x()}; }

// An axis-aligned rectangle, given by its lower left and its upper right corner.
struct Box {
  Vec2 low = Vec2::Zero(), high = Vec2::Zero();
  Vec2 size() const { return high - low; }
  Vec2 middle() const { return low + (high - low) / 2; }
  double diagonal() const { return length(size()); }
};

// The smallest box that contains m points, or the origin if there are none. O(m).
inline Box bounding_box(const Points& points) {
  if (points.empty()) return {};
  Box box{points.front(), points.front()};
  for (const Vec2& point : points) {
    box.low = box.low.cwiseMin(point);
    box.high = box.high.cwiseMax(point);
  }
  return box;
}

}  // namespace evenlift
