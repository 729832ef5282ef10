// Points and vectors of the plane, and vectors with three components. The x axis points right and
// the y axis up; counter-clockwise angles and orientations are positive. Coordinates are in the
// units of the input. Each function is O(1) unless it says otherwise, and rounds each sum and
// product by itself, so that results have the same bits everywhere. For exact decisions about input
// coordinates use predicates.h.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace evenlift {

// A point or a vector, (0, 0) by default. Two are equal if their numbers are: -0 equals 0, and NaN
// equals nothing. v[0] is x and v[1] is y.
struct Vec2 {
  double x = 0, y = 0;

  constexpr Vec2() = default;
  constexpr Vec2(double x_value, double y_value) : x(x_value), y(y_value) {}

  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : y; }
  constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : y; }
  friend constexpr bool operator==(const Vec2&, const Vec2&) = default;
};

constexpr Vec2 operator+(const Vec2& a, const Vec2& b) { return {a.x + b.x, a.y + b.y}; }
constexpr Vec2 operator-(const Vec2& a, const Vec2& b) { return {a.x - b.x, a.y - b.y}; }
constexpr Vec2 operator-(const Vec2& a) { return {-a.x, -a.y}; }
constexpr Vec2 operator*(double factor, const Vec2& a) { return {factor * a.x, factor * a.y}; }
constexpr Vec2 operator*(const Vec2& a, double factor) { return factor * a; }
constexpr Vec2 operator/(const Vec2& a, double divisor) { return {a.x / divisor, a.y / divisor}; }
constexpr Vec2& operator+=(Vec2& a, const Vec2& b) { return a = a + b; }
constexpr Vec2& operator-=(Vec2& a, const Vec2& b) { return a = a - b; }
constexpr Vec2& operator*=(Vec2& a, double factor) { return a = factor * a; }
constexpr Vec2& operator/=(Vec2& a, double divisor) { return a = a / divisor; }

using Points = std::vector<Vec2>;

// a.x b.y - a.y b.x, which is positive if `b` points to the left of `a`.
constexpr double cross(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

// The scalar product.
constexpr double dot(const Vec2& a, const Vec2& b) { return a.x * b.x + a.y * b.y; }

constexpr double squared_length(const Vec2& a) { return dot(a, a); }

// The length. It is computed with a square root, since hypot differs between libraries.
inline double length(const Vec2& a) { return std::sqrt(squared_length(a)); }

// The vector of length 1 in the direction of `a`; `a` itself if its squared length is not above 0.
inline Vec2 unit(const Vec2& a) {
  const double squared = squared_length(a);
  return squared > 0 ? a / std::sqrt(squared) : a;
}

// |a.x| + |a.y|, which is never below the length.
inline double one_norm(const Vec2& a) { return std::fabs(a.x) + std::fabs(a.y); }

// The greater of |a.x| and |a.y|, which is never above the length; |a.x| if either is NaN.
inline double max_norm(const Vec2& a) {
  const double x = std::fabs(a.x), y = std::fabs(a.y);
  return x < y ? y : x;
}

// Whether no component is infinite or NaN.
inline bool is_finite(const Vec2& a) { return std::isfinite(a.x) && std::isfinite(a.y); }

// The vector `a`, turned by +90 degrees.
constexpr Vec2 left_normal(const Vec2& a) { return {-a.y, a.x}; }

// The lesser or greater x and the lesser or greater y of two points; that of `a` if either is NaN.
constexpr Vec2 componentwise_min(const Vec2& a, const Vec2& b) {
  return {b.x < a.x ? b.x : a.x, b.y < a.y ? b.y : a.y};
}
constexpr Vec2 componentwise_max(const Vec2& a, const Vec2& b) {
  return {a.x < b.x ? b.x : a.x, a.y < b.y ? b.y : a.y};
}

// (a.x b.x, a.y b.y).
constexpr Vec2 componentwise_product(const Vec2& a, const Vec2& b) {
  return {a.x * b.x, a.y * b.y};
}

// An axis-aligned rectangle, given by its lower left and its upper right corner.
struct Box {
  Vec2 low, high;
  constexpr Vec2 size() const { return high - low; }
  constexpr Vec2 middle() const { return low + (high - low) / 2; }
  constexpr double area() const { return size().x * size().y; }
  double diagonal() const { return length(size()); }
};

// The smallest box that contains m points, or the origin if there are none. O(m).
inline Box bounding_box(const Points& points) {
  if (points.empty()) return {};
  Box box{points.front(), points.front()};
  for (const Vec2& point : points) {
    box.low = componentwise_min(box.low, point);
    box.high = componentwise_max(box.high, point);
  }
  return box;
}

// Three components: a wrench, or a point with its weight. v[0] is x, v[1] is y and v[2] is z.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  constexpr Vec3() = default;
  constexpr Vec3(double x_value, double y_value, double z_value)
      : x(x_value), y(y_value), z(z_value) {}

  constexpr double operator[](std::size_t axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  constexpr double& operator[](std::size_t axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  friend constexpr bool operator==(const Vec3&, const Vec3&) = default;
};

constexpr Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr Vec3 operator-(const Vec3& a) { return {-a.x, -a.y, -a.z}; }
constexpr Vec3 operator*(double factor, const Vec3& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
constexpr Vec3 operator/(const Vec3& a, double divisor) {
  return {a.x / divisor, a.y / divisor, a.z / divisor};
}
constexpr Vec3& operator+=(Vec3& a, const Vec3& b) { return a = a + b; }

// As for the plane. Sums are x + (y + z), whose last bit may differ from that of (x + y) + z.
constexpr double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + (a.y * b.y + a.z * b.z); }
constexpr double squared_length(const Vec3& a) { return dot(a, a); }
inline double length(const Vec3& a) { return std::sqrt(squared_length(a)); }
inline Vec3 unit(const Vec3& a) {
  const double squared = squared_length(a);
  return squared > 0 ? a / std::sqrt(squared) : a;
}
inline double one_norm(const Vec3& a) { return std::fabs(a.x) + (std::fabs(a.y) + std::fabs(a.z)); }

// The vector product.
constexpr Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

}  // namespace evenlift
