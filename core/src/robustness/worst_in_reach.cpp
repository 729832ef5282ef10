// The worst and the least loads with C anywhere within reach.
#include <algorithm>
#include <map>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/tolerance.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// The point nearest to the origin of a convex polygon, a segment or a point; the origin itself if
// inside. O(h).
Vec2 nearest_to_origin(const Points& hull) {
  const std::size_t h = hull.size();
  bool inside = h > 2;
  Vec2 nearest = hull.front();
  for (std::size_t i = 0; i < h; ++i) {
    const Vec2 &a = hull[i], along = hull[(i + 1) % h] - a;
    inside = inside && cross(along, -a) > 0;
    const double square = dot(along, along);
    const double part = square > 0 ? std::clamp(dot(along, -a) / square, 0.0, 1.0) : 0;
    const Vec2 point = a + part * along;
    if (dot(point, point) < dot(nearest, nearest)) nearest = point;
  }
  return inside ? Vec2{} : nearest;
}

// The greatest share t of a robot at p with C within reach of the origin. The rest of the weight
// acts at a point of H, so C is in t p + (1 - t) H, which shrinks towards p as t grows. Its
// distance from the origin is convex in t. If n is the direction of its nearest point, and v the
// corner of H least along n, the distance is at least n . (t p + (1 - t) v). Newton's method lowers
// t until this bound is the reach.
double greatest_share(const Vec2& p, const Points& hull, double reach) {
  constexpr int most_steps = 100;  // seldom above six
  double t = 1;
  for (int i = 0; i < most_steps; ++i) {
    Points shrunk;
    for (const Vec2& corner : hull) shrunk.push_back(t * p + (1 - t) * corner);
    const Vec2 nearest = nearest_to_origin(shrunk);
    const double distance = length(nearest);
    if (distance <= reach) break;
    const Vec2 n = nearest / distance;
    double least = dot(n, hull.front());
    for (const Vec2& corner : hull) least = std::min(least, dot(n, corner));
    const double next = std::max(0.0, (reach - least) / (dot(n, p) - least));
    if (!(next < t)) break;  // rounding ends the descent
    t = next;
  }
  return t;
}

// The least share t of a robot at p with C within reach of the origin, where H is the hull of the
// others. As above, but the distance is at most the reach from some t on, and Newton's method raises
// t until the bound is the reach.
double least_share(const Vec2& p, const Points& hull, double reach) {
  constexpr int most_steps = 100;
  constexpr double rounding = 0x1p-48;  // a nearer point has no certain direction
  double t = 0;
  for (int i = 0; i < most_steps && t < 1; ++i) {
    Points shrunk;
    for (const Vec2& corner : hull) shrunk.push_back(t * p + (1 - t) * corner);
    const Vec2 nearest = nearest_to_origin(shrunk);
    const double distance = length(nearest);
    if (distance <= reach + rounding) break;
    const Vec2 n = nearest / distance;
    double least = dot(n, hull.front());
    for (const Vec2& corner : hull) least = std::min(least, dot(n, corner));
    const double next = least > dot(n, p) ? (least - reach) / (least - dot(n, p)) : 1;
    if (!(next > t)) break;  // rounding ends the ascent
    t = std::min(next, 1.0);
  }
  return t;
}

// Positions relative to C in multiples of `unit`, and the hull of all.
struct AroundC {
  double unit = 0;
  Points robots, hull;
};

AroundC around(const Points& robots, const Vec2& centre, double unit) {
  AroundC seen{unit, {}, convex_hull(robots, near_distance(unit))};
  for (Vec2& corner : seen.hull) corner = (corner - centre) / unit;
  for (const Vec2& robot : robots) seen.robots.push_back((robot - centre) / unit);
  return seen;
}

// The least distance of C from the line through the corners beside a corner of H and from the edges
// of H, in multiples of the unit: if it is above 0, C is inside the hull of the other robots. By
// corner; nothing if H has fewer than three. O(h).
std::vector<double> room_without_corners(const Points& hull) {
  const std::size_t h = hull.size();
  if (h < 3) return {};
  const auto left_of = [&](const Vec2& a, const Vec2& b) {
    return cross(b - a, -a) / length(b - a);
  };
  double inside = left_of(hull[h - 1], hull[0]);
  for (std::size_t i = 0; i + 1 < h; ++i) inside = std::min(inside, left_of(hull[i], hull[i + 1]));
  std::vector<double> room;
  room.reserve(h);
  for (std::size_t i = 0; i < h; ++i)
    room.push_back(std::min(inside, left_of(hull[(i + h - 1) % h], hull[(i + 1) % h])));
  return room;
}

// The tolerance may leave C a little outside H.
double within_hull(const AroundC& seen, double reach) {
  return std::max(reach / seen.unit, length(nearest_to_origin(seen.hull)));
}

}  // namespace

std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight, double reach) {
  if (!(reach > 0)) return worst_loads(robots, centre, diameter, weight);
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  const AroundC seen = around(robots, centre, support->unit);
  const double within = within_hull(seen, reach);
  std::vector<double> loads;
  for (const Vec2& robot : seen.robots)
    loads.push_back(weight * greatest_share(robot, seen.hull, within));
  return loads;
}

std::optional<std::vector<double>> least_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight, double reach) {
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  const AroundC seen = around(robots, centre, support->unit);
  const double within = within_hull(seen, reach);
  const std::vector<double> room = room_without_corners(seen.hull);
  std::map<std::pair<double, double>, std::size_t> corners;
  for (std::size_t k = 0; k < seen.hull.size(); ++k)
    corners.emplace(std::pair(seen.hull[k].x, seen.hull[k].y), k);
  std::vector<double> loads(robots.size(), 0);
  constexpr double surely = 1e-6;  // more than the hull's tolerance
  for (std::size_t i = 0; i < robots.size(); ++i) {
    // Without a robot that is no corner, H remains; without most of the others, C is inside.
    const auto corner = corners.find({seen.robots[i].x, seen.robots[i].y});
    if (corner == corners.end() || (!room.empty() && room[corner->second] > surely)) continue;
    Points others = seen.robots;
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const double share =
        others.empty() ? 1 : least_share(seen.robots[i], convex_hull(others, tau), within);
    loads[i] = weight * share;
  }
  return loads;
}

}  // namespace evenlift
