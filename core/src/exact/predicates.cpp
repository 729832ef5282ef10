#include "evenlift/predicates.h"

#include <algorithm>
#include <cmath>

#include "evenlift/tolerance.h"
#include "exact/dyadic.h"
#include "exact/pseudo_angle.h"

namespace evenlift {
namespace {

// Below this size products may underflow, and the error bounds do not hold.
constexpr double smallest_safe = 1e-250;
// Stage A, the floating-point filter. A product has an error of at most 2^-50 of its size, so
// results above this fraction of the sum of the sizes have a relative error below 2^-45.
constexpr double double_filter_threshold = 0x1p-5;
// Stage B, the same for double-double: products have errors of at most 2^-100.
constexpr double double_double_filter_threshold = 0x1p-55;

// The factors of x1 y2 - x2 y1 in a number type.
template <class Number>
struct Products {
  Number x1, y1, x2, y2;
};

// The determinant x1 y2 - x2 y1 in up to three stages. `coarse` contains the factors in doubles,
// each a sum of at most two rounded differences. `size1` and `size2` bound the products before
// cancellation in the factors. `fine` and `exact` recompute the factors when their stage is
// reached.
template <class Fine, class Exact>
double adaptive_determinant(const Products<double>& coarse, double size1, double size2,
                            const Fine& fine, const Exact& exact) {
  // Thanks to gradual underflow, a rounded difference is 0 only if the exact one is.
  const bool first_is_zero = coarse.x1 == 0 || coarse.y2 == 0;
  const bool second_is_zero = coarse.x2 == 0 || coarse.y1 == 0;
  if (first_is_zero && second_is_zero) return 0;

  const double size = size1 + size2;
  if (size > smallest_safe) {
    const double value = coarse.x1 * coarse.y2 - coarse.x2 * coarse.y1;
    if (std::fabs(value) > double_filter_threshold * size) return value;

    const Products<DoubleDouble> f = fine();
    if (f.x1.is_double() && f.y1.is_double() && f.x2.is_double() && f.y2.is_double()) {
      // With integers and other short coordinates, both products are exact. They are equal for
      // points on one line of a grid, the most frequent case after the filter.
      const DoubleDouble first = two_product(f.x1.hi, f.y2.hi),
                         second = two_product(f.x2.hi, f.y1.hi);
      if (first.hi == second.hi && first.lo == second.lo) return 0;
      const double value_of_exact = (first.hi - second.hi) + (first.lo - second.lo);
      if (value_of_exact != 0) return value_of_exact;
    }
    const DoubleDouble first = f.x1 * f.y2, second = f.x2 * f.y1;
    const DoubleDouble difference = first - second;
    const double refined = difference.to_double();
    if (std::fabs(refined) > double_double_filter_threshold * size) return refined;
  }

  const Products<Dyadic> e = exact();
  return (e.x1 * e.y2 - e.x2 * e.y1).to_double();
}

DoubleDouble fine_difference(double a, double b) { return two_difference(a, b); }
Dyadic exact_difference(double a, double b) { return Dyadic(a) - Dyadic(b); }

}  // namespace

double cross_of_differences(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  const Products<double> coarse{a1.x - a0.x, a1.y - a0.y, b1.x - b0.x, b1.y - b0.y};
  return adaptive_determinant(
      coarse, std::fabs(coarse.x1 * coarse.y2), std::fabs(coarse.x2 * coarse.y1),
      [&] {
        return Products<DoubleDouble>{fine_difference(a1.x, a0.x), fine_difference(a1.y, a0.y),
                                      fine_difference(b1.x, b0.x), fine_difference(b1.y, b0.y)};
      },
      [&] {
        return Products<Dyadic>{exact_difference(a1.x, a0.x), exact_difference(a1.y, a0.y),
                                exact_difference(b1.x, b0.x), exact_difference(b1.y, b0.y)};
      });
}

double orient(const Vec2& a, const Vec2& b, const Vec2& c) {
  return cross_of_differences(a, b, a, c);
}

double dot_of_differences(const Vec2& a0, const Vec2& a1, const Vec2& b0, const Vec2& b1) {
  // a . b is the cross product of a and b turned by +90 degrees.
  const Vec2 c0(-b0.y, b0.x), c1(-b1.y, b1.x);
  return cross_of_differences(a0, a1, c0, c1);
}

double orient_mirrored(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c) {
  // b - w' is (b - centre) + (w - centre).
  const double bx = b.x - centre.x, by = b.y - centre.y;
  const double wx = w.x - centre.x, wy = w.y - centre.y;
  const Products<double> coarse{bx + wx, by + wy, c.x - b.x, c.y - b.y};
  const double size1 = (std::fabs(bx) + std::fabs(wx)) * std::fabs(coarse.y2);
  const double size2 = (std::fabs(by) + std::fabs(wy)) * std::fabs(coarse.x2);
  // The rounded sum may vanish although the exact one does not. A factor other than 0 prevents the
  // shortcut for zero factors.
  Products<double> guarded = coarse;
  if (guarded.x1 == 0 && bx != 0) guarded.x1 = 0x1p-1074;
  if (guarded.y1 == 0 && by != 0) guarded.y1 = 0x1p-1074;
  return adaptive_determinant(
      guarded, size1, size2,
      [&] {
        return Products<DoubleDouble>{
            fine_difference(b.x, centre.x) + fine_difference(w.x, centre.x),
            fine_difference(b.y, centre.y) + fine_difference(w.y, centre.y),
            fine_difference(c.x, b.x), fine_difference(c.y, b.y)};
      },
      [&] {
        return Products<Dyadic>{exact_difference(b.x, centre.x) + exact_difference(w.x, centre.x),
                                exact_difference(b.y, centre.y) + exact_difference(w.y, centre.y),
                                exact_difference(c.x, b.x), exact_difference(c.y, b.y)};
      });
}

bool ratios_tie(double a, double b) { return std::fabs(a - b) <= tau; }

bool lengths_tie(double a, double b) { return std::fabs(a - b) <= tau * std::max(a, b); }

double score_slack(double best, double floor) { return std::max(tau * best, floor); }

bool exceeds(double load, double capacity) { return load > capacity * (1 + tau); }

bool directions_agree(const Vec2& a, const Vec2& b) {
  const double side = std::fabs(cross(a, b));
  // A cheap test that avoids two square roots in most calls.
  if (side > 2 * tau * (one_norm(a) * one_norm(b))) return false;
  return dot(a, b) > 0 && side <= tau * length(a) * length(b);
}

bool is_vertical(const Vec2& direction) {
  const double x = std::fabs(direction.x);
  return x <= 2 * tau * one_norm(direction) && x <= tau * length(direction);
}

}  // namespace evenlift
