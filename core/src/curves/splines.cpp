// The curve of degree n is N(t) / W(t), and the cubic is C(t). In the Bernstein basis B_k of degree
// n + 3, N - C W has coefficients E_k, and W has W_k. The curve less the cubic is the sum of
// B_k E_k over the sum of B_k W_k. No B_k W_k is negative, so this average of E_k / W_k is no
// longer than the longest.
#include <algorithm>
#include <cmath>
#include <utility>

#include "curves/outline.h"

namespace evenlift {
namespace {

constexpr int most_bezier_halvings = 10;

// A control point (x, y) of weight w > 0, as (x w, y w, w).
using WeightedPoint = Vec3;

struct RationalBezier {
  std::size_t degree = 1;
  WeightedPoint points[max_spline_degree + 1];
};

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

// Appends curves, each of which begins where the outline ends. Lines are exact. A conic is exact if
// its control point has a weight of at most 1 once its ends are given the weight 1. Any other curve
// is halved until each part is near its cubic, which has the same ends and the same derivatives
// there: no point of the part may be farther than `tolerance` (>= 0) from the cubic's point at the
// same parameter. A part that is still too far after 10 halvings becomes a line. Control points are
// relative to `origin`, which should be near them. Stops when the outline has more than
// max_spline_pieces. O(pieces degree^2).
class Converter {
 public:
  Converter(Outline& outline, const Vec2& origin, double tolerance)
      : outline_(outline), origin_(origin), tolerance_(tolerance) {}

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
    if (outline_.pieces.size() > max_spline_pieces) return;
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
};

// As fractions of the larger side of the box around the control points: the deviation of the
// pieces, and the gap that counts as none.
constexpr double precision = 1e-7;
constexpr double same_end = 1e-6;

// The polar form of the span between the knots k and k + 1: symmetric in its arguments, linear in
// each, and the curve's point at t where all are t. The Bézier control points are its values where
// some arguments are the start of the span and the others its end.
template <class Point>
class Span {
 public:
  Span(const std::vector<Point>& control, const std::vector<double>& knots, std::size_t degree,
       std::size_t k)
      : control_(control), knots_(knots), degree_(degree), k_(k) {}

  // The value with `ends` arguments at the end of the span, by de Boor's algorithm.
  Point corner(std::size_t ends) const {
    Point d[max_spline_degree + 1];
    for (std::size_t j = 0; j <= degree_; ++j) d[j] = control_[k_ - degree_ + j];
    for (std::size_t r = 1; r <= degree_; ++r) {
      const double at = knots_[r <= ends ? k_ + 1 : k_];
      for (std::size_t j = degree_; j >= r; --j) {
        const double low = knots_[k_ - degree_ + j], high = knots_[k_ + 1 + j - r];
        d[j] = d[j - 1] + ((at - low) / (high - low)) * (d[j] - d[j - 1]);
      }
    }
    return d[degree_];
  }

 private:
  const std::vector<Point>& control_;
  const std::vector<double>& knots_;
  std::size_t degree_, k_;
};

// The pieces of all spans with a length: `place` returns the point of a value of the polar form, and
// `add` appends a span to the outline. Gaps up to `gap` count as none.
template <class Point, class Place, class Add>
std::optional<Outline> outline_of(const std::vector<Point>& control,
                                  const std::vector<double>& knots, std::size_t degree, double gap,
                                  Place place, Add add) {
  std::optional<Outline> outline;
  for (std::size_t k = degree; k + degree + 1 < knots.size(); ++k) {
    if (!(knots[k] < knots[k + 1])) continue;
    const Span<Point> span(control, knots, degree, k);
    if (!outline) outline = Outline{place(span.corner(0)), {}};
    // degree + 1 equal knots separate the curve into two parts, which may still meet.
    if (knots[k - degree] == knots[k] && length(place(span.corner(0)) - outline->end()) > gap)
      return std::nullopt;
    add(*outline, span);
    if (outline->pieces.size() > max_spline_pieces) break;
  }
  return outline;
}

void add_plain(Outline& outline, const Span<Vec2>& span, std::size_t degree) {
  if (degree == 1)
    outline.line_to(span.corner(1));
  else if (degree == 2)
    outline.quadratic_to(span.corner(1), span.corner(2));
  else
    outline.cubic_to(span.corner(1), span.corner(2), span.corner(3));
}

}  // namespace

std::optional<Outline> Outline::b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree, const std::vector<double>& weights) {
  const bool fits = degree >= 1 && degree <= max_spline_degree && control.size() > degree &&
                    knots.size() == control.size() + degree + 1 &&
                    (weights.empty() || weights.size() == control.size());
  if (!fits || !std::is_sorted(knots.begin(), knots.end())) return std::nullopt;
  const auto positive = [](double weight) { return weight > 0; };
  if (!std::all_of(weights.begin(), weights.end(), positive)) return std::nullopt;
  const Vec2 size = bounding_box(control).size();
  const double side = std::max(size.x, size.y), gap = same_end * side;
  const auto differs = [&](double weight) { return weight != weights.front(); };
  const bool weighted = std::any_of(weights.begin(), weights.end(), differs);
  if (degree <= 3 && !weighted)
    return outline_of(
        control, knots, degree, gap, [](const Vec2& point) { return point; },
        [&](Outline& outline, const Span<Vec2>& span) { add_plain(outline, span, degree); });

  // Weights are divided by the greatest, so that they cannot overflow.
  const Vec2 origin = control.front();
  const double greatest = weighted ? *std::max_element(weights.begin(), weights.end()) : 1;
  std::vector<WeightedPoint> points;
  points.reserve(control.size());
  for (std::size_t i = 0; i < control.size(); ++i) {
    const double weight = weighted ? weights[i] / greatest : 1;
    const Vec2 point = (control[i] - origin) * weight;
    points.push_back({point.x, point.y, weight});
  }
  return outline_of(
      points, knots, degree, gap, [&](const WeightedPoint& point) { return origin + plain(point); },
      [&](Outline& outline, const Span<WeightedPoint>& span) {
        RationalBezier curve;
        curve.degree = degree;
        for (std::size_t i = 0; i <= degree; ++i) curve.points[i] = span.corner(i);
        Converter(outline, origin, precision * side).add(curve);
      });
}

}  // namespace evenlift
