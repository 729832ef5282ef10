#include "robustness/best_load.h"

#include <algorithm>
#include <functional>
#include <utility>

#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "polygon/clip.h"
#include "robustness/support.h"

namespace evenlift {
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
