// Bits of doubles, double-double arithmetic, and pseudo-angles.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// --- Converts doubles to their bits and back, without std::bit_cast, which older versions of
// Emscripten lack.

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

inline std::uint64_t to_bits(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline double from_bits(std::uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Whether all bits of a and b are equal. So -0 and 0 differ. O(1).
inline bool same_bits(double a, double b) { return to_bits(a) == to_bits(b); }

// --- Double-double arithmetic: the unevaluated sum hi + lo of two doubles has about 106 bits (T. J.
// Dekker, A floating-point technique for extending the available precision, 1971). The operations
// need strict IEEE arithmetic without fused multiply-add, which the build guarantees. Callers must
// avoid products that are below 2^-969 in size but not 0, since these lose bits.

struct DoubleDouble {
  double hi = 0;
  double lo = 0;

  DoubleDouble() = default;
  explicit DoubleDouble(double value) : hi(value) {}
  DoubleDouble(double high, double low) : hi(high), lo(low) {}

  double to_double() const { return hi + lo; }
  bool is_double() const { return lo == 0; }
};

// a + b exactly, for |a| >= |b|. |lo| is at most half a unit in the last place of hi.
inline DoubleDouble quick_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

// a + b exactly.
inline DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double part = sum - a;
  return {sum, (a - (sum - part)) + (b - part)};
}

// a - b exactly.
inline DoubleDouble two_difference(double a, double b) { return two_sum(a, -b); }

// The product a b, exactly, for |a|, |b| < 2^996.
inline DoubleDouble two_product(double a, double b) {
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double product = a * b;
  const double ta = splitter * a, tb = splitter * b;
  const double a_high = ta - (ta - a), b_high = tb - (tb - b);
  const double a_low = a - a_high, b_low = b - b_high;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  DoubleDouble high = two_sum(a.hi, b.hi);
  const DoubleDouble low = two_sum(a.lo, b.lo);
  high = quick_two_sum(high.hi, high.lo + low.hi);
  return quick_two_sum(high.hi, high.lo + low.lo);
}

inline DoubleDouble operator-(const DoubleDouble& a) { return {-a.hi, -a.lo}; }
inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + (-b); }

inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const DoubleDouble product = two_product(a.hi, b.hi);
  return quick_two_sum(product.hi, product.lo + (a.hi * b.lo + a.lo * b.hi));
}

inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double q1 = a.hi / b.hi;
  DoubleDouble remainder = a - DoubleDouble(q1) * b;
  const double q2 = remainder.hi / b.hi;
  remainder = remainder - DoubleDouble(q2) * b;
  return quick_two_sum(q1, q2) + DoubleDouble(remainder.hi / b.hi);
}

// --- Pseudo-angles are numbers that order directions as angles do, but need no trigonometry.

// The diamond angle: the position of a direction along the diamond |x| + |y| = 1, in [0, 4),
// counter-clockwise from the positive x axis; 0 for the zero vector. Opposite directions differ by
// 2. Rounding errors are far below tau, the tolerance within which directions agree. O(1).
inline double pseudo_angle(const Vec2& u) {
  const double size = one_norm(u);
  if (size == 0) return 0;
  const double part = u.y / size;
  if (u.x < 0) return 2 - part;
  if (u.y >= 0) return part;
  const double angle = 4 + part;
  return angle < 4 ? angle : 0;  // if part is just below 0, 4 + part rounds to 4, the full turn
}

// The pseudo-angle from `origin` counter-clockwise to `angle`, in [-1, 3). It is negative for
// angles up to a quarter turn before the origin.
inline double pseudo_angle_from(double origin, double angle) {
  double difference = angle - origin;
  if (difference < -1) difference += 4;
  if (difference >= 3) difference -= 4;
  return difference;
}

// A pseudo-angle of the line along u, which must not be 0: a position along the square max(|x|,
// |y|) = 1. The values for u and -u are equal or differ by 4. While u turns from -90 to 180
// degrees, the value begins at -2 and never decreases, except that it drops from 3 to -1 at 135
// degrees. Rounding does not change this, since each operation rounds correctly. O(1).
inline double line_pseudo_angle(const Vec2& u) {
  if (std::fabs(u.y) <= std::fabs(u.x)) return u.y / u.x;
  return (u.y > 0 ? 2.0 : -2.0) - u.x / u.y;
}

// The direction in which C sees an item of for_each_between(), relative to the two corners.
enum class SeenAt : std::uint8_t { first_corner, between, second_corner };

// Calls visit(item, seen_at), counter-clockwise, for the items that C sees between the corners h1
// and h2 of H or, within tolerance, in the direction of one of them. h1 and h2 are relative to C.
// `items` must be sorted by pseudo-angle; seen(item) must return a struct with the item's
// `position` (relative to C) and `pseudo_angle`. O(log m + visits) for m items.
template <class Items, class See, class Visit>
void for_each_between(const Items& items, See seen, const Vec2& h1, const Vec2& h2, Visit visit) {
  const double margin = 4 * tau;  // pseudo-angles of directions that agree differ by less
  const double angle1 = pseudo_angle(h1);
  const double width = pseudo_angle_from(angle1, pseudo_angle(h2));
  const double start = angle1 - margin < 0 ? angle1 - margin + 4 : angle1 - margin;
  const auto first = std::lower_bound(
      items.begin(), items.end(), start,
      [&](const auto& item, double angle) { return seen(item).pseudo_angle < angle; });
  const std::size_t n = items.size(), offset = static_cast<std::size_t>(first - items.begin());
  for (std::size_t k = 0; k < n; ++k) {
    const auto& item = items[offset + k < n ? offset + k : offset + k - n];
    const double angle = pseudo_angle_from(angle1, seen(item).pseudo_angle);
    if (angle > width + margin) break;
    const Vec2& position = seen(item).position;
    if (directions_agree(h1, position)) {
      visit(item, SeenAt::first_corner);
    } else if (directions_agree(h2, position)) {
      visit(item, SeenAt::second_corner);
    } else if (angle >= 0 && angle < width) {
      visit(item, SeenAt::between);
    }
  }
}

}  // namespace evenlift
