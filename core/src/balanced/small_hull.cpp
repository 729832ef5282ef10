#include "balanced/small_hull.h"

#include <cassert>

#include "exact/sorted_indices.h"

namespace evenlift::balanced {
namespace {

using Few = std::array<Vec2, most_robots>;

std::size_t sort_positions(const std::vector<LiftingPoint>& robots, const Vec2& centre,
                           Few& sorted) {
  std::size_t number = 0;
  for (const LiftingPoint& robot : robots) {
    const Vec2 position = robot.position - centre;
    std::size_t at = number++;
    for (; at > 0 && lexicographically_before(position, sorted[at - 1]); --at)
      sorted[at] = sorted[at - 1];
    sorted[at] = position;
  }
  return number;
}

// A chain of left turns through points in sorted or reverse order.
class Chain {
 public:
  void append(const Vec2& p) {
    while (size_ >= 2 && !turns_left(p)) --size_;
    points_[size_++] = p;
  }

  // Leaves out the last point.
  void add_to(SmallHull& hull) const {
    for (std::size_t i = 0; i + 1 < size_; ++i) hull.corners[hull.size++] = points_[i];
  }

 private:
  bool turns_left(const Vec2& p) const {
    const Vec2 &a = points_[size_ - 2], &b = points_[size_ - 1];
    return cross(b - a, p - a) > 0;
  }

  Few points_;
  std::size_t size_ = 0;
};

}  // namespace

SmallHull small_hull(const std::vector<LiftingPoint>& robots, const Vec2& centre) {
  assert(robots.size() <= most_robots);
  Few sorted;
  const std::size_t number = sort_positions(robots, centre, sorted);
  SmallHull hull;
  Chain lower, upper;
  for (std::size_t i = 0; i < number; ++i) lower.append(sorted[i]);
  for (std::size_t i = number; i-- > 0;) upper.append(sorted[i]);
  lower.add_to(hull);
  upper.add_to(hull);
  for (std::size_t i = 2; i < hull.size; ++i)
    hull.area += cross(hull.corners[i - 1] - hull.corners[0], hull.corners[i] - hull.corners[0]);
  hull.area /= 2;
  return hull;
}

}  // namespace evenlift::balanced
