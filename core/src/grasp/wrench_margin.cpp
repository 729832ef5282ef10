#include "grasp/wrench_margin.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>

#include "exact/dyadic.h"

namespace evenlift {
namespace {

using Index = std::uint32_t;
using Triangle = std::array<Index, 3>;

// Sign of (b - a) x (c - a) . (d - a), exactly.
int orient3(const Wrench& a, const Wrench& b, const Wrench& c, const Wrench& d) {
  const Wrench p = b - a, q = c - a, r = d - a;
  const double value = p.dot(q.cross(r));
  const double size = p.cwiseAbs().sum() * q.cwiseAbs().sum() * r.cwiseAbs().sum();
  if (std::fabs(value) > 0x1p-48 * size) return value > 0 ? 1 : -1;
  using Row = std::array<Dyadic, 3>;
  const auto difference = [&](const Wrench& v) {
    return Row{Dyadic(v.x()) - Dyadic(a.x()), Dyadic(v.y()) - Dyadic(a.y()),
               Dyadic(v.z()) - Dyadic(a.z())};
  };
  const Row x = difference(b), y = difference(c), z = difference(d);
  return (x[0] * (y[1] * z[2] - y[2] * z[1]) + x[1] * (y[2] * z[0] - y[0] * z[2]) +
          x[2] * (y[0] * z[1] - y[1] * z[0]))
      .sign();
}

bool collinear(const Wrench& a, const Wrench& b, const Wrench& c) {
  // In space three points are on one line if their shadows on the coordinate planes are.
  const auto flat = [&](int i, int j) {
    const auto d = [](double u, double v) { return Dyadic(u) - Dyadic(v); };
    return (d(b[i], a[i]) * d(c[j], a[j]) - d(b[j], a[j]) * d(c[i], a[i])).sign() == 0;
  };
  return flat(0, 1) && flat(1, 2) && flat(2, 0);
}

// Four points that are not on one plane, the first three counter-clockwise seen from outside; none
// if all are on one.
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

// Facets of the convex hull, counter-clockwise seen from outside; empty if all points are on one
// plane. Point after point: the facets that see it give way to the cone from it over their rim.
std::vector<Triangle> hull_facets(const std::vector<Wrench>& w) {
  const auto start = first_tetrahedron(w);
  if (!start) return {};
  const auto [a, b, c, d] = *start;
  std::vector<Triangle> facets{{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}};
  for (Index p = 0; p < w.size(); ++p) {
    const auto first_visible = std::partition(facets.begin(), facets.end(), [&](const Triangle& f) {
      return orient3(w[f[0]], w[f[1]], w[f[2]], w[p]) <= 0;
    });
    if (first_visible == facets.end()) continue;
    std::map<std::pair<Index, Index>, bool> rim;
    for (auto f = first_visible; f != facets.end(); ++f) {
      for (std::size_t k = 0; k < 3; ++k) rim[{(*f)[k], (*f)[(k + 1) % 3]}] = true;
    }
    facets.erase(first_visible, facets.end());
    for (const auto& [edge, present] : rim) {
      if (!rim.contains({edge.second, edge.first})) facets.push_back({edge.first, edge.second, p});
    }
  }
  return facets;
}

// Distance of the plane through three points from the origin, positive if they turn
// counter-clockwise seen from beyond it. Wrenches of parallel edges are on one line but for
// rounding, which leaves facets that are slivers: only exactly do these lie outside the hull.
double distance_of_plane(const Wrench& a, const Wrench& b, const Wrench& c) {
  const Wrench p = b - a, q = c - a;
  const Wrench normal = p.cross(q);
  constexpr double wide_enough = 1e-6;
  if (normal.squaredNorm() > wide_enough * p.squaredNorm() * q.squaredNorm())
    return normal.dot(a) / normal.norm();

  const auto difference = [&](const Wrench& v, int i) { return Dyadic(v[i]) - Dyadic(a[i]); };
  const auto component = [&](int i, int j) {
    return difference(b, i) * difference(c, j) - difference(b, j) * difference(c, i);
  };
  const std::array<Dyadic, 3> exact{component(1, 2), component(2, 0), component(0, 1)};
  const Dyadic height = exact[0] * Dyadic(a[0]) + exact[1] * Dyadic(a[1]) + exact[2] * Dyadic(a[2]);
  return height.to_double() /
         Wrench(exact[0].to_double(), exact[1].to_double(), exact[2].to_double()).norm();
}

// The point of least length in the affine hull of the corral, as weights of its points.
std::optional<Eigen::VectorXd> affine_minimizer(const std::vector<Wrench>& w,
                                                const std::vector<Index>& corral) {
  const auto n = static_cast<Eigen::Index>(corral.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Ones(n + 1, n + 1);
  system(0, 0) = 0;
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j < n; ++j) {
      system(i + 1, j + 1) =
          w[corral[static_cast<std::size_t>(i)]].dot(w[corral[static_cast<std::size_t>(j)]]);
    }
  }
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  right(0) = 1;
  const Eigen::FullPivLU<Eigen::MatrixXd> lu(system);
  if (lu.rank() < n + 1) return std::nullopt;
  return Eigen::VectorXd(lu.solve(right).tail(n));
}

// Distance of the origin from the hull of points: P. Wolfe, Finding the nearest point in a polytope
// (1976). Also for points on one plane, line or place.
double distance_from_origin(const std::vector<Wrench>& w) {
  std::vector<Index> corral{0};
  std::vector<double> weights{1};
  Wrench nearest = w[0];
  for (std::size_t round = 0; round < 50 * w.size() + 100; ++round) {
    Index best = 0;
    for (Index i = 1; i < w.size(); ++i) {
      if (w[i].dot(nearest) < w[best].dot(nearest)) best = i;
    }
    const double gap = nearest.squaredNorm() - w[best].dot(nearest);
    if (gap <= 1e-15 * std::max(1.0, nearest.squaredNorm())) break;
    if (std::find(corral.begin(), corral.end(), best) != corral.end()) break;
    corral.push_back(best);
    weights.push_back(0);
    // Move to the minimizer, leaving points behind whose weight would turn negative.
    for (bool inside = false; !inside && !corral.empty();) {
      const auto target = affine_minimizer(w, corral);
      if (!target) {
        corral.pop_back();
        weights.pop_back();
        break;
      }
      double step = 1;
      for (std::size_t k = 0; k < corral.size(); ++k) {
        const double goal = (*target)(static_cast<Eigen::Index>(k));
        if (goal < 1e-14) step = std::min(step, weights[k] / std::max(weights[k] - goal, 1e-300));
      }
      inside = step >= 1;
      std::vector<Index> kept;
      std::vector<double> kept_weights;
      for (std::size_t k = 0; k < corral.size(); ++k) {
        const double weight =
            weights[k] + step * ((*target)(static_cast<Eigen::Index>(k)) - weights[k]);
        if (weight <= 1e-14) continue;
        kept.push_back(corral[k]);
        kept_weights.push_back(weight);
      }
      inside = inside || kept.size() == corral.size();
      corral = kept;
      weights = kept_weights;
    }
    nearest.setZero();
    for (std::size_t k = 0; k < corral.size(); ++k) nearest += weights[k] * w[corral[k]];
  }
  return nearest.norm();
}

}  // namespace

double wrench_margin(const std::vector<Wrench>& wrenches) {
  const std::vector<Triangle> facets = hull_facets(wrenches);
  double least = facets.empty() ? 0 : std::numeric_limits<double>::infinity();
  for (Triangle facet : facets) {
    // From its first wrench on: where std::partition leaves a facet, and so how it began, differs
    // between standard libraries, and the rounding must not.
    std::rotate(facet.begin(), std::min_element(facet.begin(), facet.end()), facet.end());
    least = std::min(least,
                     distance_of_plane(wrenches[facet[0]], wrenches[facet[1]], wrenches[facet[2]]));
  }
  return least > 0 ? least : 0.0 - distance_from_origin(wrenches);  // never -0
}

}  // namespace evenlift
