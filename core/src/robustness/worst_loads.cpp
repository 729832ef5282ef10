#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// Here q (load_models.h) is the end beyond C.
std::vector<double> shares_on_line(const Points& at) {
  double least = 0, greatest = 0;
  for (const Vec2& robot : at) {
    least = std::min(least, robot.x);
    greatest = std::max(greatest, robot.x);
  }
  std::vector<double> shares;
  for (const Vec2& robot : at) {
    const double t = robot.x;
    const double other = t > 0 ? -least : greatest;
    shares.push_back(t == 0 ? 1 : other / (std::fabs(t) + other));
  }
  return shares;
}

// The edges of H in order about C, which is inside. A share is the lever about the edge through
// which the ray leaves: C's distance from it, divided by the robot's.
class Rim {
 public:
  explicit Rim(const Points& hull) {
    const SortedIndices order = sorted_indices(hull.size(), [&](std::uint32_t i, std::uint32_t j) {
      return pseudo_angle(hull[i]) < pseudo_angle(hull[j]);
    });
    for (const std::uint32_t i : order) {
      corners_.push_back(hull[i]);
      angles_.push_back(pseudo_angle(hull[i]));
    }
  }

  double share(const Vec2& robot) const {
    const std::size_t n = corners_.size();
    const auto next = std::upper_bound(angles_.begin(), angles_.end(), pseudo_angle(-robot));
    const auto edge = static_cast<std::size_t>(next - angles_.begin()) + n - 1;
    // Near a corner, rounding may choose the neighbouring edge. The ray leaves through the edge
    // with the least share.
    return std::min(
        {share(robot, (edge - 1) % n), share(robot, edge % n), share(robot, (edge + 1) % n)});
  }

 private:
  double share(const Vec2& robot, std::size_t edge) const {
    const Vec2 &a = corners_[edge], &b = corners_[(edge + 1) % corners_.size()];
    const double of_centre = cross(b - a, -a), of_robot = cross(b - a, robot - a);
    return of_robot > of_centre ? std::max(0.0, of_centre) / of_robot : 1;
  }

  Points corners_;
  std::vector<double> angles_;
};

std::vector<double> shares_on_area(const Support& support) {
  const Rim rim(support.hull);
  std::vector<double> shares;
  for (const Vec2& robot : support.at) shares.push_back(rim.share(robot));
  return shares;
}

}  // namespace

std::optional<std::vector<double>> worst_loads(const Points& robots, const Vec2& centre,
                                               double diameter, double weight) {
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  std::vector<double> loads =
      support->on_a_line ? shares_on_line(support->at) : shares_on_area(*support);
  for (double& load : loads) load *= weight;
  return spread_out(*support, loads, robots.size());
}

// --- The worst and the least loads with C anywhere within reach.

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

namespace {

constexpr std::size_t most_robots_by_pairs = 64;

// The sum of max(0, g) over the robots, for g = 1 + b . q, and its gradient in b.
struct Sum {
  double value = 0;
  Vec2 slope;
};

Sum sum_at(const Points& robots, const Vec2& b) {
  Sum sum;
  for (const Vec2& robot : robots) {
    const double g = 1 + dot(b, robot);
    if (g <= 0) continue;
    sum.value += g;
    sum.slope += robot;
  }
  return sum;
}

// The b for which no g exceeds m + 1. A g above m makes the sum exceed that at b = 0, so this
// polygon contains the least sum. Edges of H become its corners.
Points region_of_least_sum(const Points& hull, std::size_t m) {
  Points region;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const Vec2 outward = -left_normal(b - a);
    region.push_back(outward * (static_cast<double>(m) / dot(outward, a)));
  }
  return region;
}

Vec2 centroid_of(const Points& ring) {
  Vec2 weighted;
  double area = 0;
  for (std::size_t i = 2; i < ring.size(); ++i) {
    const Vec2 u = ring[i - 1] - ring[0], v = ring[i] - ring[0];
    const double part = cross(u, v);
    area += part;
    weighted += part * (u + v);
  }
  return area > 0 ? Vec2(ring[0] + weighted / (3 * area)) : ring[0];
}

// The greatest share over lines through p and another robot.
double best_through(const Points& robots, const Vec2& p) {
  double best = 0;
  for (const Vec2& q : robots) {
    const Vec2 along = q - p;
    const double of_centre = cross(along, -p);
    if (of_centre <= 0) continue;
    double sum = 0;
    for (const Vec2& robot : robots) sum += std::max(0.0, cross(along, robot - p));
    best = std::max(best, of_centre / sum);
  }
  return best;
}

// On a line: the greatest share over the functions g that grow along it from 0 at a robot behind C.
double best_ahead(std::vector<double> along) {
  std::sort(along.begin(), along.end(), std::greater<>());
  double best = 0, sum = 0;  // `sum`: of g over the robots ahead
  for (std::size_t k = 1; k < along.size(); ++k) {
    sum += static_cast<double>(k) * (along[k - 1] - along[k]);
    if (along[k] < 0) best = std::max(best, -along[k] / sum);
  }
  return best;
}

}  // namespace

double best_share_by_pairs(const Points& robots) {
  double best = 1 / static_cast<double>(robots.size());
  for (const Vec2& robot : robots) best = std::max(best, best_through(robots, robot));
  return std::min(best, 1.0);
}

double best_share_by_cuts(const Points& robots, const Points& hull) {
  constexpr int most_steps = 400;
  constexpr double settled = 0x1p-44;  // of the sum
  Points region = region_of_least_sum(hull, robots.size());
  double least = static_cast<double>(robots.size());  // the sum at b = 0
  double bound = 0;                                   // no sum is less
  for (int step = 0; step < most_steps && region.size() >= 3; ++step) {
    // A line through the centroid leaves at most 5/9 of the area on either side.
    const Vec2 middle = centroid_of(region);
    const Sum sum = sum_at(robots, middle);
    least = std::min(least, sum.value);
    double below = 0;
    for (const Vec2& corner : region) below = std::min(below, dot(sum.slope, corner - middle));
    bound = std::max(bound, sum.value + below);
    if (least - bound <= settled * least) break;
    region = clip_left_of_ray(region, middle, left_normal(sum.slope));
  }
  return std::min(1 / least, 1.0);
}

double best_share_on_line(const Points& robots) {
  std::vector<double> along, back;
  for (const Vec2& robot : robots) {
    along.push_back(robot.x);
    back.push_back(-robot.x);
  }
  const double even = 1 / static_cast<double>(robots.size());
  return std::min(1.0, std::max({even, best_ahead(std::move(along)), best_ahead(std::move(back))}));
}

std::optional<double> best_load(const Points& robots, const Vec2& centre, double diameter,
                                double weight) {
  const std::optional<Support> support = find_support(robots, centre, diameter);
  if (!support) return std::nullopt;
  if (support->on_a_line) return weight * best_share_on_line(support->at);
  if (support->at.size() <= most_robots_by_pairs) return weight * best_share_by_pairs(support->at);
  return weight * best_share_by_cuts(support->at, support->hull);
}

}  // namespace evenlift
