#include "stands/obstacles.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evenlift {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Extent {
  double low = infinity, high = -infinity;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
  bool empty() const { return low > high; }
  std::optional<Stretch> stretch() const {
    return empty() ? std::nullopt : std::optional(Stretch{low, high});
  }
};

double x_at(const Vec2& p, const Vec2& q, double y) {
  const double part = (y - p.y) / (q.y - p.y);
  return p.x + std::clamp(part, 0.0, 1.0) * (q.x - p.x);
}

// The x of a segment where `low` <= y <= `high`.
Extent within(const Vec2& p, const Vec2& q, double low, double high) {
  Extent extent;
  for (const Vec2& end : {p, q})
    if (end.y >= low && end.y <= high) extent.add(end.x);
  for (const double y : {low, high})
    if ((p.y < y) != (q.y < y) && p.y != q.y) extent.add(x_at(p, q, y));
  return extent;
}

// Where the segment crosses height y. Upper ends count, lower ones do not.
Extent crossing(const Vec2& p, const Vec2& q, double y) {
  Extent extent;
  if ((p.y < y) != (q.y < y)) extent.add(x_at(p, q, y));
  return extent;
}

Vec2 upside_down(const Vec2& v) { return {v.x, -v.y}; }

// Where the hand must be beneath the object, within tau L. Empty if its depth is less than a tenth
// of its width.
struct HandDepths {
  double from, to;
  HandDepths(const RobotSize& robot, double near)
      : from(robot.width / 10 + near), to(robot.depth - near) {}
  bool empty() const { return from > to; }
};

}  // namespace

// Intersects the line of the body's middle with the capsule of its radius about the other edge. A
// capsule is convex, so this is one interval. Its ends are on the discs about the vertices or on
// the straight sides.
std::optional<Stretch> lost_to_body(const SeenObstacle& other, const RobotSize& robot,
                                    double near) {
  const double radius = robot.radius - near, height = robot.radius + robot.reach;
  if (radius <= 0) return std::nullopt;
  const Vec2 &p = other.p, &q = other.q;
  if (std::min(p.y, q.y) >= height + radius || std::max(p.y, q.y) <= height - radius)
    return std::nullopt;
  Extent extent;
  for (const Vec2& end : {p, q}) {
    const double rise = height - end.y;
    if (std::fabs(rise) >= radius) continue;
    const double half = std::sqrt((radius - rise) * (radius + rise));
    extent.add(end.x - half);
    extent.add(end.x + half);
  }
  const Vec2 along = q - p;
  const double size = length(along);
  if (size > 0) {
    const Vec2 aside = left_normal(along) * (radius / size);
    for (const Vec2& offset : {aside, Vec2(-aside)}) {
      const Extent side = crossing(p + offset, q + offset, height);
      if (!side.empty()) extent.add(side.low);
    }
  }
  return extent.stretch();
}

// On the object's side of the line, the other edge does not obstruct the arm.
std::optional<Stretch> lost_to_arm(const SeenObstacle& other, const RobotSize& robot) {
  const Vec2 &p = other.p, &q = other.q;
  if (robot.reach <= 0 || std::max(p.y, q.y) <= 0) return std::nullopt;
  return within(p, q, 0, robot.radius + robot.reach).stretch();
}

// The hand at these depths, narrower by tau L on each side, must not meet the other edge.
std::optional<Stretch> lost_to_hand(const SeenObstacle& other, const RobotSize& robot,
                                    double near) {
  const HandDepths depths(robot, near);
  if (depths.empty()) return std::nullopt;
  const Extent met = within(upside_down(other.p), upside_down(other.q), depths.from, depths.to);
  if (met.empty()) return std::nullopt;
  const double half = std::max(robot.width / 2 - near, 0.0);
  return Stretch{met.low - half, met.high + half};
}

std::optional<Stretch> lost_to_mark(const SeenObstacle& other, const EdgePart& part,
                                    const RobotSize& robot, double near) {
  const double half = robot.width / 2;
  if (half <= 0) return std::nullopt;
  const Vec2 way = other.q - other.p;
  const Extent marked =
      within(other.p + part.from * way, other.p + part.to * way, -(robot.width / 10 + near), near);
  if (marked.empty()) return std::nullopt;
  return Stretch{marked.low - half, marked.high + half};
}

std::optional<Stretch> parted_from_hand(const SeenObstacle& other, const RobotSize& robot,
                                        double near) {
  const HandDepths depths(robot, near);
  if (depths.empty()) return std::nullopt;
  return within(upside_down(other.p), upside_down(other.q), 0, depths.from).stretch();
}

}  // namespace evenlift
