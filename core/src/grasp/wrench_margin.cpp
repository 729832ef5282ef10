#include "grasp/grasp.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "evenlift/tolerance.h"
#include "exact/dyadic.h"

namespace evenlift {
namespace {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;

// Whether the four points are on two lines along the third axis, or three of them on one: then all
// are in one plane. Wrenches of contacts on edges with the same normal are on one such line.
bool on_parallel_lines(const Wrench& a, const Wrench& b, const Wrench& c, const Wrench& d) {
  const auto on_one = [](const Wrench& p, const Wrench& q) { return p.x == q.x && p.y == q.y; };
  return on_one(a, b) + on_one(a, c) + on_one(a, d) + on_one(b, c) + on_one(b, d) + on_one(c, d) >=
         2;
}

// The exact sign of (b - a) x (c - a) . (d - a): the orientation of a tetrahedron.
int orient3(const Wrench& a, const Wrench& b, const Wrench& c, const Wrench& d) {
  const Wrench p = b - a, q = c - a, r = d - a;
  const double value = dot(p, cross(q, r));
  const double permanent = one_norm(p) * one_norm(q) * one_norm(r);
  constexpr double filter_threshold = 0x1p-48;  // as in predicates.cpp
  if (std::fabs(value) > filter_threshold * permanent) return value > 0 ? 1 : -1;
  // Most of the others: hull_facets() asks about corners, too.
  if (d == a || d == b || d == c || on_parallel_lines(a, b, c, d)) return 0;
  using Row = std::array<Dyadic, 3>;
  const auto difference = [&](const Wrench& v) {
    return Row{Dyadic(v.x) - Dyadic(a.x), Dyadic(v.y) - Dyadic(a.y), Dyadic(v.z) - Dyadic(a.z)};
  };
  const Row x = difference(b), y = difference(c), z = difference(d);
  return (x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
          x[2] * (y[0] * z[1] - y[1] * z[0]))
      .sign();
}

bool collinear(const Wrench& a, const Wrench& b, const Wrench& c) {
  // Points are on one line if their projections onto the coordinate planes are.
  const auto flat = [&](std::size_t i, std::size_t j) {
    const auto d = [](double u, double v) { return Dyadic(u) - Dyadic(v); };
    return (d(b[i], a[i]) * d(c[j], a[j]) - d(b[j], a[j]) * d(c[i], a[i])).sign() == 0;
  };
  return flat(0, 1) && flat(1, 2) && flat(2, 0);
}

// Four points that are not in one plane, the first three counter-clockwise as seen from outside;
// nothing if there are none.
std::optional<std::array<Index, 4>> first_tetrahedron(const std::vector<Wrench>& w) {
  const auto n = static_cast<Index>(w.size());
  Index b = 1;
  while (b < n && w[b] == w[0]) ++b;
  Index c = b + 1;
  while (c < n && collinear(w[0], w[b], w[c])) ++c;
  for (Index d = c + 1; d < n; ++d) {
    const int side = orient3(w[0], w[b], w[c], w[d]);
    if (side < 0) return std::array<Index, 4>{0, b, c, d};
    if (side > 0) return std::array<Index, 4>{0, c, b, d};
  }
  return std::nullopt;
}

// The facets of the convex hull, counter-clockwise as seen from outside; empty if all points are in
// one plane. The hull grows point by point: triangles from a new point replace the facets that it
// sees.
std::vector<Triangle> hull_facets(const std::vector<Wrench>& w) {
  const auto start = first_tetrahedron(w);
  if (!start) return {};
  const auto [a, b, c, d] = *start;
  std::vector<Triangle> facets{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  std::vector<std::pair<Index, Index>> sides;
  for (Index p = 0; p < w.size(); ++p) {
    const auto first_visible = std::partition(facets.begin(), facets.end(), [&](const Triangle& f) {
      return orient3(w[f[0]], w[f[1]], w[f[2]], w[p]) <= 0;
    });
    if (first_visible == facets.end()) continue;
    sides.clear();
    for (auto f = first_visible; f != facets.end(); ++f)
      for (std::size_t k = 0; k < 3; ++k) sides.emplace_back((*f)[k], (*f)[(k + 1) % 3]);
    facets.erase(first_visible, facets.end());
    std::sort(sides.begin(), sides.end());
    // A side of two visible facets has both directions.
    for (const auto& [from, to] : sides)
      if (!std::binary_search(sides.begin(), sides.end(), std::pair(to, from)))
        facets.push_back({from, to, p});
  }
  return facets;
}

// The distance of the plane through three points from the origin, positive if they turn
// counter-clockwise as seen from beyond the plane. Wrenches of parallel edges are on one line
// except for rounding, so some facets are slivers. Their planes must be computed exactly, or they
// could cut through the hull.
double distance_of_plane(const Wrench& a, const Wrench& b, const Wrench& c) {
  const Wrench p = b - a, q = c - a;
  const Wrench normal = cross(p, q);
  constexpr double not_a_sliver = 1e-6;  // the squared sine of the angle at a
  if (squared_length(normal) > not_a_sliver * squared_length(p) * squared_length(q))
    return dot(normal, a) / length(normal);

  const auto difference = [&](const Wrench& v, std::size_t i) {
    return Dyadic(v[i]) - Dyadic(a[i]);
  };
  const auto component = [&](std::size_t i, std::size_t j) {
    return difference(b, i) * difference(c, j) - difference(b, j) * difference(c, i);
  };
  const std::array<Dyadic, 3> exact{component(1, 2), component(2, 0), component(0, 1)};
  const Dyadic height = exact[0] * Dyadic(a[0]) + exact[1] * Dyadic(a[1]) + exact[2] * Dyadic(a[2]);
  return height.to_double() /
         length(Wrench(exact[0].to_double(), exact[1].to_double(), exact[2].to_double()));
}

// P. Wolfe's algorithm (Finding the nearest point in a polytope, 1976). It also works for points in
// one plane, on one line or at one place.
class NearestPoint {
 public:
  explicit NearestPoint(const std::vector<Wrench>& points) : points_(points), nearest_(points[0]) {}

  // The point of the convex hull that is nearest to the origin.
  const Wrench& find() {
    const std::size_t most_cycles = 50 * points_.size() + 100;
    for (std::size_t cycle = 0; cycle < most_cycles; ++cycle) {
      if (!major_cycle()) break;
    }
    return nearest_;
  }

 private:
  // Adds the point farthest towards the origin to the corral and moves to the new nearest point.
  // False if the nearest point is already found.
  bool major_cycle() {
    constexpr double optimality_gap = 1e-15;
    const Index added = farthest_towards_origin();
    const double gap = squared_length(nearest_) - dot(points_[added], nearest_);
    if (gap <= optimality_gap * std::max(1.0, squared_length(nearest_))) return false;
    if (std::find(corral_.begin(), corral_.end(), added) != corral_.end()) return false;
    corral_.push_back(added);
    weights_.push_back(0);
    while (!corral_.empty() && minor_cycle()) {
    }
    nearest_ = {};
    for (std::size_t k = 0; k < corral_.size(); ++k) nearest_ += weights_[k] * points_[corral_[k]];
    return true;
  }

  // Moves towards the nearest point of the corral's affine hull, at most to the boundary of the
  // corral's convex hull. Points whose weight is then 0 leave the corral. True if another minor
  // cycle must follow.
  bool minor_cycle() {
    const auto target = affine_minimizer();
    if (!target) {
      corral_.pop_back();
      weights_.pop_back();
      return false;
    }
    double step = 1;
    constexpr double above_zero = 1e-300;  // no division by 0
    for (std::size_t k = 0; k < corral_.size(); ++k) {
      const double goal = (*target)(static_cast<Eigen::Index>(k));
      if (goal < least_weight)
        step = std::min(step, weights_[k] / std::max(weights_[k] - goal, above_zero));
    }
    std::vector<Index> kept;
    std::vector<double> kept_weights;
    for (std::size_t k = 0; k < corral_.size(); ++k) {
      const double weight =
          weights_[k] + step * ((*target)(static_cast<Eigen::Index>(k)) - weights_[k]);
      if (weight <= least_weight) continue;
      kept.push_back(corral_[k]);
      kept_weights.push_back(weight);
    }
    const bool is_last = step >= 1 || kept.size() == corral_.size();
    corral_ = std::move(kept);
    weights_ = std::move(kept_weights);
    return !is_last;
  }

  Index farthest_towards_origin() const {
    Index best = 0;
    for (Index i = 1; i < points_.size(); ++i) {
      if (dot(points_[i], nearest_) < dot(points_[best], nearest_)) best = i;
    }
    return best;
  }

  // The point of the corral's affine hull that is nearest to the origin, as weights of its points;
  // nothing if these are affinely dependent.
  std::optional<Eigen::VectorXd> affine_minimizer() const {
    const auto n = static_cast<Eigen::Index>(corral_.size());
    const auto point = [&](Eigen::Index i) -> const Wrench& {
      return points_[corral_[static_cast<std::size_t>(i)]];
    };
    Eigen::MatrixXd system = Eigen::MatrixXd::Ones(n + 1, n + 1);
    system(0, 0) = 0;
    for (Eigen::Index i = 0; i < n; ++i) {
      for (Eigen::Index j = 0; j < n; ++j) system(i + 1, j + 1) = dot(point(i), point(j));
    }
    Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
    right(0) = 1;
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(system);
    if (lu.rank() < n + 1) return std::nullopt;
    return Eigen::VectorXd(lu.solve(right).tail(n));
  }

  static constexpr double least_weight = 1e-14;  // a smaller weight counts as 0

  const std::vector<Wrench>& points_;
  Wrench nearest_;
  // The corral: affinely independent points whose convex combination with these weights is
  // `nearest_`.
  std::vector<Index> corral_{0};
  std::vector<double> weights_{1};
};

// The vector at unit length, or that of the x axis if it is too short to have a direction.
Wrench direction_of(const Wrench& vector) {
  const double size = length(vector);
  return size > tau ? vector / size : Wrench(1, 0, 0);
}

Wrench normal_of(const std::vector<Wrench>& w, const Triangle& facet) {
  const Wrench p = w[facet[1]] - w[facet[0]], q = w[facet[2]] - w[facet[0]];
  return cross(p, q);
}

Index farthest_along(const std::vector<Wrench>& wrenches, const Wrench& direction) {
  Index best = 0;
  for (Index i = 1; i < wrenches.size(); ++i)
    if (dot(wrenches[i], direction) > dot(wrenches[best], direction)) best = i;
  return best;
}

WeakestDirection weakest_of_few(const std::vector<Wrench>& wrenches) {
  const std::vector<Triangle> facets = hull_facets(wrenches);
  double least = facets.empty() ? 0 : std::numeric_limits<double>::infinity();
  Triangle weakest{};
  for (Triangle facet : facets) {
    // Begins with the facet's first wrench. The order in which std::partition leaves facets may
    // differ between standard libraries; the rounding must not.
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    const double distance =
        distance_of_plane(wrenches[facet[0]], wrenches[facet[1]], wrenches[facet[2]]);
    if (distance < least) weakest = facet;
    least = std::min(least, distance);
  }
  if (least > tau) return {least, direction_of(normal_of(wrenches, weakest))};
  // The planes of a flat hull's facets may all pass through an origin beside the hull; then only
  // rounding puts it on their inner side. The distance of a facet's plane has an error of some
  // 1e-16 divided by twice the facet's area. For areas of 1e-9 or more, `beside` exceeds it.
  constexpr double beside = 1e-7;
  NearestPoint search(wrenches);
  const Wrench& nearest = search.find();
  const double distance = length(nearest);
  // Far from the origin the nearest point gives the direction, otherwise the facet.
  const Wrench direction = distance > beside || facets.empty()
                               ? direction_of(-nearest)
                               : direction_of(normal_of(wrenches, weakest));
  return {least > 0 && distance <= beside ? least : 0.0 - distance, direction};  // never -0
}

// The normal of the plane through the origin and the two wrenches that span it best.
Wrench normal_through_origin(const std::vector<Wrench>& wrenches) {
  Wrench best;
  for (std::size_t i = 0; i < wrenches.size(); ++i)
    for (std::size_t j = i + 1; j < wrenches.size(); ++j) {
      const Wrench normal = cross(wrenches[i], wrenches[j]);
      if (squared_length(normal) > squared_length(best)) best = normal;
    }
  return direction_of(best);
}

// Begins with the wrenches that reach farthest along the axes. Adds the one that reaches farthest
// in the weakest direction of the active ones, until none reaches farther: then that direction is
// the weakest of all.
class FewOfMany {
 public:
  explicit FewOfMany(const std::vector<Wrench>& all) : all_(all) {
    for (const Wrench& axis : {Wrench(1, 0, 0), Wrench(0, 1, 0), Wrench(0, 0, 1)}) {
      activate(-axis);
      activate(axis);
    }
  }

  WeakestDirection weakest() {
    while (true) {
      const std::vector<Wrench> active = active_wrenches();
      const WeakestDirection found = weakest_of_few(active);
      if (reach(found.direction) <= found.margin + same_reach) return found;
      if (activate(found.direction)) continue;
      // The weakest facet is too small to have a direction, as when all wrenches are in one plane.
      const Wrench normal = normal_through_origin(active);
      const bool added = activate(normal), also_added = activate(-normal);
      if (added || also_added) continue;
      return std::max(reach(normal), reach(-normal)) <= tau ? found : weakest_of_few(all_);
    }
  }

 private:
  // More than the rounding of u . w, and less than matters for a margin.
  static constexpr double same_reach = 1e-13;

  double reach(const Wrench& direction) const {
    return dot(all_[farthest_along(all_, direction)], direction);
  }

  // Activates the wrench that reaches farthest. False if it already was active.
  bool activate(const Wrench& direction) {
    const Index added = farthest_along(all_, direction);
    const auto at = std::lower_bound(active_.begin(), active_.end(), added);
    if (at != active_.end() && *at == added) return false;
    active_.insert(at, added);
    return true;
  }

  std::vector<Wrench> active_wrenches() const {
    std::vector<Wrench> wrenches;
    wrenches.reserve(active_.size());
    for (const Index i : active_) wrenches.push_back(all_[i]);
    return wrenches;
  }

  const std::vector<Wrench>& all_;
  std::vector<Index> active_;  // ascending
};

}  // namespace

double wrench_margin(const std::vector<Wrench>& wrenches) {
  return weakest_direction(wrenches).margin;
}

WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches) {
  constexpr std::size_t few = 32;
  return wrenches.size() <= few ? weakest_of_few(wrenches) : FewOfMany(wrenches).weakest();
}

}  // namespace evenlift
