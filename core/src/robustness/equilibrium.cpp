#include "evenlift/equilibrium.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/hull.h"
#include "evenlift/plane.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/uncertainty.h"
#include "robustness/known_size.h"
#include "robustness/support.h"

namespace evenlift {
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

}  // namespace evenlift
