#include "robustness/support.h"

#include <algorithm>
#include <cmath>

#include "evenlift/hull.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "robustness/known_size.h"

namespace evenlift {
namespace {

// A line, with all robots on its part from 0 to `reach`.
struct Stand {
  Vec2 from, along;  // `along` has length 1
  double reach = 0;
};

Stand stand_between(const Vec2& a, const Vec2& b) {
  const double reach = length(b - a);
  return {a, reach > 0 ? Vec2((b - a) / reach) : Vec2(1, 0), reach};
}

bool holds(const Stand& stand, const Vec2& centre, double near) {
  const Vec2 d = centre - stand.from;
  const double along = dot(d, stand.along), across = std::fabs(cross(stand.along, d));
  return across <= near && along >= -near && along <= stand.reach + near;
}

double left_of(const Vec2& a, const Vec2& b, const Vec2& point) {
  return orient(a, b, point) / length(b - a);
}

// Moves C onto the robots' part of the line if rounding or the tolerance leaves it outside.
void move_onto(std::vector<double>& along) {
  const auto [least, greatest] = std::minmax_element(along.begin(), along.end());
  const double beyond = std::max(*least, 0.0) + std::min(*greatest, 0.0);
  for (double& t : along) {
    t -= beyond;
    if (std::fabs(t) <= tau) t = 0;
  }
}

Support on_line(const Points& robots, std::vector<std::uint32_t> bearing, const Vec2& centre,
                double unit, const Vec2& direction) {
  std::vector<double> along;
  for (const std::uint32_t i : bearing) along.push_back(dot(robots[i] - centre, direction) / unit);
  move_onto(along);
  Support support{unit, true, std::move(bearing), {}, {}};
  for (const double t : along) support.at.emplace_back(t, 0);
  return support;
}

Support on_area(const Points& robots, const Points& hull, const Vec2& centre, double unit) {
  Support support{unit, false, indices_below(robots.size()), {}, {}};
  for (const Vec2& robot : robots) support.at.push_back((robot - centre) / unit);
  for (const Vec2& corner : hull) support.hull.push_back((corner - centre) / unit);
  return support;
}

// The edge of H nearest to C, if within tolerance.
std::optional<Stand> edge_below(const Points& hull, const Vec2& centre, double near) {
  std::optional<Stand> nearest;
  double least = 0;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const Stand stand = stand_between(a, b);
    if (!holds(stand, centre, near)) continue;
    const double distance = std::fabs(left_of(a, b, centre));
    if (nearest && distance >= least) continue;
    nearest = stand;
    least = distance;
  }
  return nearest;
}

bool is_inside(const Points& hull, const Vec2& centre, double near) {
  for (std::size_t i = 0; i < hull.size(); ++i)
    if (left_of(hull[i], hull[(i + 1) % hull.size()], centre) <= near) return false;
  return true;
}

}  // namespace

std::optional<Support> find_support(const Points& robots, const Vec2& centre, double diameter) {
  const double unit = known_size(robots, centre, diameter);
  const double near = near_distance(unit);
  const Points hull = convex_hull(robots, near);
  if (hull.empty()) return std::nullopt;
  if (hull.size() < 3) {
    const Stand stand = stand_between(hull.front(), hull.back());
    if (!holds(stand, centre, near)) return std::nullopt;
    return on_line(robots, indices_below(robots.size()), centre, unit, stand.along);
  }
  if (is_inside(hull, centre, near)) return on_area(robots, hull, centre, unit);
  const std::optional<Stand> edge = edge_below(hull, centre, near);
  if (!edge) return std::nullopt;
  std::vector<std::uint32_t> bearing;
  for (std::uint32_t i = 0; i < robots.size(); ++i)
    if (std::fabs(cross(edge->along, robots[i] - edge->from)) <= near) bearing.push_back(i);
  return on_line(robots, std::move(bearing), centre, unit, edge->along);
}

std::vector<double> spread_out(const Support& support, const std::vector<double>& loads,
                               std::size_t m) {
  std::vector<double> all(m, 0);
  for (std::size_t i = 0; i < loads.size(); ++i) all[support.robots[i]] = loads[i];
  return all;
}

}  // namespace evenlift
