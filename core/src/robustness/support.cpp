// The depth of C among the robots, by a line that turns once around C.
#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/equilibrium.h"
#include "evenlift/failures.h"
#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/uncertainty.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// Whether a robot within tolerance of the line counts.
enum class OnTheLine { counts, does_not };

// A robot at d from C is on the side of the unit vector u if u . d >= -near (counts) or u . d >
// near (does not). These u form an arc of pseudo-angles: closed and slightly more than a half-turn,
// or open and slightly less.
struct Arc {
  double begin, end;
};

Arc arc_of(const Vec2& d, double near, OnTheLine on_the_line) {
  const double distance = length(d);
  // At the arc's ends, u . d is `along`, and u has the components `along` and `across` over |d|.
  const double along = on_the_line == OnTheLine::counts ? -near : near;
  const double across = std::sqrt((distance - near) * (distance + near));
  const Vec2 side = across * left_normal(d);
  return {pseudo_angle(along * d - side), pseudo_angle(along * d + side)};
}

// The least number of arcs that overlap in one direction.
int least_overlap(const std::vector<Arc>& arcs, OnTheLine on_the_line) {
  // Event 2 i begins arc i, and event 2 i + 1 ends it.
  const auto angle = [&](std::uint32_t event) {
    const Arc& arc = arcs[event / 2];
    return event % 2 == 0 ? arc.begin : arc.end;
  };
  // Where closed arcs meet, they overlap; open arcs leave a gap.
  const std::uint32_t first_of_equal = on_the_line == OnTheLine::counts ? 0 : 1;
  const SortedIndices events =
      sorted_indices(2 * arcs.size(), [&](std::uint32_t i, std::uint32_t j) {
        if (angle(i) != angle(j)) return angle(i) < angle(j);
        return i % 2 == first_of_equal && j % 2 != first_of_equal;
      });
  int overlap = 0;
  for (const Arc& arc : arcs) overlap += arc.begin > arc.end ? 1 : 0;
  int least = overlap;
  for (const std::uint32_t event : events) {
    overlap += event % 2 == 0 ? 1 : -1;
    least = std::min(least, overlap);
  }
  return least;
}

// The least number of robots on one side of a line through C.
//
// C and each robot are at most L apart, and `near` is at least tau L. So arcs differ from a
// half-turn by at least tau at either end, and the rounding of directions, about 1e-16, matters
// only at the limit of the tolerance.
int depth(const Points& robots, const Vec2& centre, double near, OnTheLine on_the_line) {
  std::vector<Arc> arcs;
  arcs.reserve(robots.size());
  int at_centre = 0;
  for (const Vec2& robot : robots) {
    const Vec2 d = robot - centre;
    if (length(d) <= near) {
      ++at_centre;
    } else {
      arcs.push_back(arc_of(d, near, on_the_line));
    }
  }
  const int always = on_the_line == OnTheLine::counts ? at_centre : 0;
  return always + least_overlap(arcs, on_the_line);
}

double tolerance(const Points& robots, const Vec2& centre, double diameter) {
  return near_distance(known_size(robots, centre, diameter));
}

}  // namespace

int failures_carried(const Points& robots, const Vec2& centre, double diameter) {
  return depth(robots, centre, tolerance(robots, centre, diameter), OnTheLine::counts) - 1;
}

int failures_steady(const Points& robots, const Vec2& centre, double diameter, double inside) {
  const double near = tolerance(robots, centre, diameter);
  return depth(robots, centre, std::max(near, inside - near), OnTheLine::does_not) - 1;
}

namespace {

// The first robot within tolerance of a corner of H, else the nearest.
std::uint32_t robot_at(const Points& robots, const Vec2& corner, double near) {
  std::uint32_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    const double distance = length(robots[i] - corner);
    if (distance <= near) return i;
    if (distance < least) {
      least = distance;
      nearest = i;
    }
  }
  return nearest;
}

struct Edge {
  Vec2 from, to;
};

// The ends of the edge that C is farthest beyond. If edges tie, the smallest robot number decides.
std::vector<std::uint32_t> farthest_edge(const Points& robots, const Points& hull,
                                         const Vec2& centre, double near) {
  double farthest = 0;
  std::vector<std::uint32_t> ends;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Edge edge{hull[i], hull[(i + 1) % hull.size()]};
    const double beyond = -orient(edge.from, edge.to, centre) / length(edge.to - edge.from);
    std::vector<std::uint32_t> now = {robot_at(robots, edge.from, near),
                                      robot_at(robots, edge.to, near)};
    std::sort(now.begin(), now.end());
    const bool farther = ends.empty() || beyond > farthest + near;
    if (!farther && (beyond < farthest - near || ends < now)) continue;
    farthest = std::max(beyond, farthest);
    ends = std::move(now);
  }
  return ends;
}

std::vector<std::uint32_t> tipped_over(const Points& robots, const Points& hull, const Vec2& centre,
                                       double near) {
  if (hull.size() == 1) return {robot_at(robots, hull[0], near)};
  if (hull.size() > 2) return farthest_edge(robots, hull, centre, near);
  const double across = std::fabs(orient(hull[0], hull[1], centre)) / length(hull[1] - hull[0]);
  const Vec2 nearer = length(centre - hull[0]) < length(centre - hull[1]) ? hull[0] : hull[1];
  if (across <= near) return {robot_at(robots, nearer, near)};
  std::vector<std::uint32_t> ends = {robot_at(robots, hull[0], near),
                                     robot_at(robots, hull[1], near)};
  std::sort(ends.begin(), ends.end());
  return ends;
}

double distance_from(const Points& hull, const Vec2& centre) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i)
    least = std::min(least, distance_to_segment(hull[i], hull[(i + 1) % hull.size()], centre));
  return least;
}

}  // namespace

Equilibrium analyse_equilibrium(const Points& robots, const Vec2& centre, double diameter) {
  Equilibrium equilibrium;
  if (robots.empty()) return equilibrium;
  const double near = near_distance(known_size(robots, centre, diameter));
  const Points hull = convex_hull(robots, near);
  equilibrium.stands = find_support(robots, centre, diameter).has_value();
  if (equilibrium.stands) {
    equilibrium.com_margin = tipping_distance(hull, centre, diameter);
  } else {
    equilibrium.com_margin = -distance_from(hull, centre);
    equilibrium.tips_over = tipped_over(robots, hull, centre, near);
  }
  return equilibrium;
}

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
