// The curve of degree n is N(t) / W(t), and the cubic is C(t). In the Bernstein basis B_k of degree
// n + 3, N - C W has coefficients E_k, and W has W_k. The curve less the cubic is the sum of
// B_k E_k over the sum of B_k W_k. No B_k W_k is negative, so this average of E_k / W_k is no
// longer than the longest.
#include "curves/rational_bezier.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace evenlift {
namespace {

constexpr int most_bezier_halvings = 10;

Vec2 plain(const WeightedPoint& p) { return Vec2(p.x, p.y) / p.z; }

struct Cubic {
  Vec2 points[4];
};

Cubic tangent_cubic(const RationalBezier& curve) {
  const std::size_t n = curve.degree;
  const WeightedPoint* p = curve.points;
  const Vec2 start = plain(p[0]), end = plain(p[n]);
  const double third = static_cast<double>(n) / 3;
  return {{start, start + (plain(p[1]) - start) * (third * (p[1].z / p[0].z)),
           end + (plain(p[n - 1]) - end) * (third * (p[n - 1].z / p[n].z)), end}};
}

// An upper bound of the distance of the curve from the cubic at the same parameter.
double deviation(const RationalBezier& curve, const Cubic& cubic,
                 const double (&binomials)[max_spline_degree + 1]) {
  constexpr double cubic_factors[] = {1, 3, 3, 1};
  const std::size_t n = curve.degree;
  double greatest = 0;
  for (std::size_t k = 0; k <= n + 3; ++k) {
    Vec2 difference;
    double weight = 0;
    for (std::size_t j = k > n ? k - n : 0; j <= std::min<std::size_t>(k, 3); ++j) {
      const WeightedPoint& p = curve.points[k - j];
      const double factor = binomials[k - j] * cubic_factors[j];
      difference += factor * (Vec2(p.x, p.y) - p.z * cubic.points[j]);
      weight += factor * p.z;
    }
    greatest = std::max(greatest, length(difference) / weight);
  }
  return greatest;
}

// De Casteljau's algorithm at the middle.
std::pair<RationalBezier, RationalBezier> halves(const RationalBezier& curve) {
  const std::size_t n = curve.degree;
  RationalBezier left = curve, right = curve;
  for (std::size_t i = 0; i <= n; ++i) {
    left.points[i] = right.points[0];
    for (std::size_t j = 0; j + i < n; ++j)
      right.points[j] = (right.points[j] + right.points[j + 1]) / 2;
  }
  return {left, right};
}

class Converter {
 public:
  Converter(Outline& outline, const Vec2& origin, double tolerance, std::size_t most)
      : outline_(outline), origin_(origin), tolerance_(tolerance), most_(most) {}

  void add(const RationalBezier& curve) {
    if (curve.degree == 1) return outline_.line_to(origin_ + plain(curve.points[1]));
    if (curve.degree == 2 && add_conic(curve)) return;
    for (std::size_t k = 1; k <= curve.degree; ++k)
      binomials_[k] =
          binomials_[k - 1] * static_cast<double>(curve.degree - k + 1) / static_cast<double>(k);
    add_cubics(curve, 0);
  }

 private:
  // A change of the parameter gives both ends the weight 1.
  bool add_conic(const RationalBezier& curve) {
    const WeightedPoint* p = curve.points;
    const double weight = p[1].z / std::sqrt(p[0].z) / std::sqrt(p[2].z);
    if (!(weight > 0 && weight <= 1)) return false;
    outline_.pieces.push_back(
        {CurvePiece::Kind::conic, origin_ + plain(p[2]), origin_ + plain(p[1]), Vec2{}, weight});
    return true;
  }

  void add_cubics(const RationalBezier& curve, int depth) {
    if (outline_.pieces.size() > most_) return;
    const Cubic cubic = tangent_cubic(curve);
    if (deviation(curve, cubic, binomials_) <= tolerance_) {
      outline_.cubic_to(origin_ + cubic.points[1], origin_ + cubic.points[2],
                        origin_ + cubic.points[3]);
    } else if (depth < most_bezier_halvings) {
      const auto [left, right] = halves(curve);
      add_cubics(left, depth + 1);
      add_cubics(right, depth + 1);
    } else {
      outline_.line_to(origin_ + cubic.points[3]);
    }
  }

  Outline& outline_;
  double binomials_[max_spline_degree + 1] = {1};  // of the degree
  Vec2 origin_;
  double tolerance_;
  std::size_t most_;
};

}  // namespace

void add_rational(Outline& outline, const RationalBezier& curve, const Vec2& origin,
                  double tolerance, std::size_t most) {
  Converter(outline, origin, tolerance, most).add(curve);
}

}  // namespace evenlift
