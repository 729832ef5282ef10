#include "evenlift/hull.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "polygon/straight_corner.h"

namespace evenlift {
namespace {

// Appends the monotone chain of left turns through [first, last), without its last point.
template <class Iterator>
void append_chain(Iterator first, Iterator last, Points& hull) {
  const std::size_t base = hull.size();
  for (Iterator p = first; p != last; ++p) {
    while (hull.size() >= base + 2 && orient(hull[hull.size() - 2], hull.back(), *p) <= 0)
      hull.pop_back();
    hull.push_back(*p);
  }
  hull.pop_back();
}

// The corners farthest apart along the longer side of the bounding box: the ends if all are near
// one line.
std::pair<Vec2, Vec2> extremes(const Points& hull) {
  const auto by_x = std::minmax_element(hull.begin(), hull.end(), lexicographically_before);
  const auto by_y = std::minmax_element(hull.begin(), hull.end(), [](const Vec2& a, const Vec2& b) {
    return a.y != b.y ? a.y < b.y : a.x < b.x;
  });
  const double width = by_x.second->x - by_x.first->x;
  const double height = by_y.second->y - by_y.first->y;
  if (width >= height) return {*by_x.first, *by_x.second};
  std::pair<Vec2, Vec2> ends{*by_y.first, *by_y.second};
  if (lexicographically_before(ends.second, ends.first)) std::swap(ends.first, ends.second);
  return ends;
}

// The greatest distance of a corner from the line a b.
double distance_from_line(const Points& hull, const Vec2& a, const Vec2& b) {
  double greatest = 0;
  for (const Vec2& v : hull) greatest = std::max(greatest, std::fabs(orient(a, b, v)));
  return greatest / length(b - a);
}

// Whether all corners are within `flat` of one line. A convex polygon is narrowest perpendicular to
// a side. O(h) for most hulls of h corners, O(h^2) for nearly flat ones.
bool is_flat(const Points& hull, const std::pair<Vec2, Vec2>& ends, double flat) {
  // The ends are farthest apart along an axis. In a strip of width 2 flat with both, no point is
  // farther than 4 flat from the line through them.
  if (distance_from_line(hull, ends.first, ends.second) > 4 * flat) return false;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (distance_from_line(hull, hull[i], hull[(i + 1) % hull.size()]) <= 2 * flat) return true;
  }
  return false;
}

double squared_distance(const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  return dot(d, d);
}

// Removes the corners that only rounding makes: those within `flat` of the corner before, and those
// on a straight run, at most tau times the spanning side's length from it. The tip of a thin hull
// may be as near to that side's line, but is beyond its ends. The search begins with the corner
// farthest from the first, which cannot be within a straight run. A corner goes only with all
// others of its run, so many slight turns that add up remain.
Points without_straight_corners(const Points& hull, double flat) {
  const std::size_t n = hull.size();
  std::size_t start = 0;
  for (std::size_t i = 1; i < n; ++i) {
    if (squared_distance(hull[0], hull[i]) > squared_distance(hull[0], hull[start])) start = i;
  }
  const auto corner = [&](std::size_t i) -> const Vec2& { return hull[(start + i) % n]; };
  const auto is_straight = [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from + 1; i < to; ++i)
      if (!is_straight_corner(corner(from), corner(i), corner(to), flat)) return false;
    return true;
  };
  Points kept{corner(0)};
  std::size_t last = 0;
  for (std::size_t next = 2; next <= n; ++next) {
    if (is_straight(last, next)) continue;
    last = next - 1;
    kept.push_back(corner(last));
  }
  if (kept.size() < 3) return hull;
  std::rotate(kept.begin(), std::min_element(kept.begin(), kept.end(), lexicographically_before),
              kept.end());
  return kept;
}

// Sorted from left to right.
Points hull_of_sorted(Points points, double flat) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;

  Points hull;
  append_chain(points.begin(), points.end(), hull);
  append_chain(points.rbegin(), points.rend(), hull);

  const std::pair<Vec2, Vec2> ends = extremes(hull);
  if (is_flat(hull, ends, flat)) return {ends.first, ends.second};
  return flat > 0 ? without_straight_corners(hull, flat) : hull;
}

}  // namespace

Points convex_hull(Points points, double flat) {
  Points sorted;
  sorted.reserve(points.size());
  for (const std::uint32_t i : lexicographic_order(points)) sorted.push_back(points[i]);
  return hull_of_sorted(std::move(sorted), flat);
}

Points widen_hull(const Points& hull, const Vec2& p, const Vec2& q, double flat) {
  const auto right = std::max_element(hull.begin(), hull.end(), lexicographically_before);
  Points points;
  points.reserve(hull.size() + 2);
  std::merge(hull.begin(), right, hull.rbegin(), std::make_reverse_iterator(right),
             std::back_inserter(points), lexicographically_before);
  for (const Vec2& added : {p, q}) {
    points.insert(std::upper_bound(points.begin(), points.end(), added, lexicographically_before),
                  added);
  }
  return hull_of_sorted(std::move(points), flat);
}

double diameter(const Points& hull) {
  const std::size_t n = hull.size();
  const auto corner = [&](std::size_t i) -> const Vec2& { return hull[i % n]; };
  double greatest = 0;
  // Finds the corner farthest from each side's line. Of the two corners farthest apart, one is such
  // a corner and the other an end of its side. If two sides are parallel up to rounding, either
  // corner of the other side may seem farther.
  std::size_t far = 1;
  for (std::size_t side = 0; side < n; ++side) {
    const Vec2 &a = corner(side), &b = corner(side + 1);
    const auto distance = [&](std::size_t i) { return cross(b - a, corner(i) - a); };
    while (distance(far + 1) > distance(far)) ++far;
    for (const Vec2& end : {a, b})
      for (const std::size_t i : {far, far + 1})
        greatest = std::max(greatest, squared_distance(end, corner(i)));
  }
  return std::sqrt(greatest);
}

bool is_straight_corner(const Vec2& before, const Vec2& corner, const Vec2& after, double flat) {
  const double least = flat * flat;
  if (squared_distance(before, corner) <= least || squared_distance(corner, after) <= least)
    return true;
  const double squared = squared_distance(before, after),
               along = dot(corner - before, after - before);
  return along >= 0 && along <= squared &&
         std::fabs(orient(before, after, corner)) <= tau * squared;
}

double signed_area(const Points& points) {
  double twice = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    twice += cross(points[i - 1] - points[0], points[i] - points[0]);
  }
  return 0.5 * twice;
}

}  // namespace evenlift
