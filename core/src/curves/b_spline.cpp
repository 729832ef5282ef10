#include <algorithm>
#include <cmath>

#include "curves/outline.h"

namespace evenlift {
namespace {

constexpr std::size_t max_degree = 3;

// The span between the knots k and k + 1, as its polar form: symmetric in its arguments, linear in
// each, and equal to the curve's point at t where all arguments are t. The control points of the
// Bézier curve are its values where some arguments are the start of the span and the others its
// end.
class Span {
 public:
  Span(const Points& control, const std::vector<double>& knots, std::size_t degree, std::size_t k)
      : control_(control), knots_(knots), degree_(degree), k_(k) {}

  // The value with `ends` of the arguments at the end of the span. De Boor's algorithm.
  Vec2 corner(std::size_t ends) const {
    Vec2 d[max_degree + 1];
    for (std::size_t j = 0; j <= degree_; ++j) d[j] = control_[k_ - degree_ + j];
    for (std::size_t r = 1; r <= degree_; ++r) {
      const double at = knots_[r <= ends ? k_ + 1 : k_];
      for (std::size_t j = degree_; j >= r; --j) {
        const double low = knots_[k_ - degree_ + j], high = knots_[k_ + 1 + j - r];
        d[j] = d[j - 1] + (d[j] - d[j - 1]) * ((at - low) / (high - low));
      }
    }
    return d[degree_];
  }

 private:
  const Points& control_;
  const std::vector<double>& knots_;
  std::size_t degree_, k_;
};

}  // namespace

std::optional<Outline> Outline::b_spline(const Points& control, const std::vector<double>& knots,
                                         std::size_t degree) {
  const bool fits = degree >= 1 && degree <= max_degree && control.size() > degree &&
                    knots.size() == control.size() + degree + 1;
  if (!fits || !std::is_sorted(knots.begin(), knots.end())) return std::nullopt;
  std::optional<Outline> outline;
  for (std::size_t k = degree; k < control.size(); ++k) {
    if (!(knots[k] < knots[k + 1])) continue;
    // degree + 1 equal knots separate the curve into two.
    if (outline && knots[k - degree] == knots[k]) return std::nullopt;
    const Span span(control, knots, degree, k);
    if (!outline) outline = Outline{span.corner(0), {}};
    if (degree == 1)
      outline->line_to(span.corner(1));
    else if (degree == 2)
      outline->quadratic_to(span.corner(1), span.corner(2));
    else
      outline->cubic_to(span.corner(1), span.corner(2), span.corner(3));
  }
  return outline;
}

}  // namespace evenlift
