#include "evenlift/hull.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "evenlift/predicates.h"
#include "sorted_indices.h"

namespace evenlift {
namespace {

// Appends the chain of left turns through [first, last) to `hull`, without its last point.
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

// The two corners that are farthest apart along the longer side of the bounding box. If all corners
// lie near one line, these are its ends.
std::pair<Vec2, Vec2> extremes(const Points& hull) {
  const auto by_x = std::minmax_element(hull.begin(), hull.end(), lexicographically_before);
  const auto by_y = std::minmax_element(hull.begin(), hull.end(), [](const Vec2& a, const Vec2& b) {
    return a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
  });
  const double width = by_x.second->x() - by_x.first->x();
  const double height = by_y.second->y() - by_y.first->y();
  if (width >= height) return {*by_x.first, *by_x.second};
  std::pair<Vec2, Vec2> ends{*by_y.first, *by_y.second};
  if (lexicographically_before(ends.second, ends.first)) std::swap(ends.first, ends.second);
  return ends;
}

// The hull of points from left to right.
Points hull_of_sorted(Points points, double flat) {
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 2) return points;

  Points hull;
  append_chain(points.begin(), points.end(), hull);
  append_chain(points.rbegin(), points.rend(), hull);

  const std::pair<Vec2, Vec2> ends = extremes(hull);
  const double reach = flat * length(ends.second - ends.first);
  const bool is_flat = std::all_of(hull.begin(), hull.end(), [&](const Vec2& v) {
    return std::fabs(orient(ends.first, ends.second, v)) <= reach;
  });
  if (is_flat) return {ends.first, ends.second};
  return hull;
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

double signed_area(const Points& points) {
  double twice = 0;
  for (std::size_t i = 2; i < points.size(); ++i) {
    twice += cross(points[i - 1] - points[0], points[i] - points[0]);
  }
  return 0.5 * twice;
}

}  // namespace evenlift
