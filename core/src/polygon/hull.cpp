#include "evenlift/hull.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "polygon/corners.h"

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

namespace {

// Clips a ring by a half-plane, point by point. Outputs each point inside and, before it, where the
// ring crossed the line since the last point.
class HalfPlaneClipper {
 public:
  HalfPlaneClipper(const Vec2& a, const Vec2& direction) : a_(a), line_(direction) {}

  double side(const Vec2& v) const { return cross(line_, v - a_); }

  void begin_after(const Vec2& last) {
    from_ = last;
    from_side_ = side(last);
  }

  template <class Emit>
  void advance(const Vec2& to, Emit emit) {
    const double to_side = side(to);
    if ((from_side_ < 0) != (to_side < 0)) {
      emit(Vec2(from_ + (from_side_ / (from_side_ - to_side)) * (to - from_)));
    }
    if (to_side >= 0) emit(to);
    from_ = to;
    from_side_ = to_side;
  }

  // The last output point for the whole ring, if any.
  std::optional<Vec2> find_last(const Points& ring) const {
    for (std::size_t i = ring.size(); i-- > 0;) {
      const Vec2 &from = ring[i == 0 ? ring.size() - 1 : i - 1], &to = ring[i];
      const double from_side = side(from), to_side = side(to);
      if (to_side < 0 && from_side < 0) continue;
      if (to_side >= 0) return to;
      return Vec2(from + (from_side / (from_side - to_side)) * (to - from));
    }
    return std::nullopt;
  }

 private:
  Vec2 a_, line_;
  Vec2 from_;
  double from_side_ = 0;
};

// Computes signed_area() from points one by one.
class RunningArea {
 public:
  void add(const Vec2& v) {
    if (number_++ == 0) {
      first_ = v;
      return;
    }
    const Vec2 arm = v - first_;
    if (number_ > 2) doubled_area_ += cross(arm_, arm);
    arm_ = arm;
  }
  double area() const { return 0.5 * doubled_area_; }

 private:
  std::size_t number_ = 0;
  Vec2 first_, arm_;
  double doubled_area_ = 0;
};

}  // namespace

Points clip_left(const Points& ring, const Vec2& a, const Vec2& b) {
  return clip_left_of_ray(ring, a, b - a);
}

Points clip_left_of_ray(const Points& ring, const Vec2& from, const Vec2& direction) {
  Points kept;
  if (ring.empty()) return kept;
  kept.reserve(ring.size() + 4);
  HalfPlaneClipper clipper(from, direction);
  clipper.begin_after(ring.back());
  for (const Vec2& v : ring) clipper.advance(v, [&](const Vec2& point) { kept.push_back(point); });
  return kept;
}

double area_left_of_both(const Points& ring, const Vec2& a, const Vec2& b, const Vec2& c) {
  HalfPlaneClipper first(a, b - a), second(b, c - b);
  const std::optional<Vec2> last = first.find_last(ring);
  if (!last) return 0;
  first.begin_after(ring.back());
  second.begin_after(*last);
  RunningArea area;
  for (const Vec2& v : ring) {
    first.advance(v, [&](const Vec2& point) {
      second.advance(point, [&](const Vec2& kept) { area.add(kept); });
    });
  }
  return area.area();
}

namespace {

// The sides of the polygon as seen from a point inside, which is the origin here. The area is that
// of a closed curve: the ring, with all parts beyond a side pulled to the side along the rays to the
// origin.
class Fan {
 public:
  explicit Fan(const Points& hull) {
    for (const Vec2& corner : hull) origin_ += corner / static_cast<double>(hull.size());
    for (const Vec2& corner : hull) corners_.push_back(corner - origin_);
    const auto first = std::min_element(
        corners_.begin(), corners_.end(),
        [](const Vec2& a, const Vec2& b) { return pseudo_angle(a) < pseudo_angle(b); });
    std::rotate(corners_.begin(), first, corners_.end());
    for (const Vec2& corner : corners_) angles_.push_back(pseudo_angle(corner));
  }

  const Vec2& origin() const { return origin_; }

  // Twice the area between the origin and the edge from a to b, within the polygon.
  double below(const Vec2& a, const Vec2& b) const {
    const double turn = cross(a, b);
    if (turn < 0) return -below(b, a);
    if (!(turn > 0)) return 0;
    double sum = 0;
    Vec2 from = a;
    std::size_t sector = sector_of(a);
    for (std::size_t passed = 0; passed < corners_.size(); ++passed) {
      const Vec2& corner = corners_[next(sector)];
      const double after_a = cross(a, corner), before_b = cross(corner, b);
      if (!(before_b > 0) || after_a < 0) break;
      const Vec2 to = a + after_a / (after_a + before_b) * (b - a);
      sum += in_sector(sector, from, to);
      from = to;
      sector = next(sector);
    }
    return sum + in_sector(sector, from, b);
  }

 private:
  std::size_t next(std::size_t sector) const {
    return sector + 1 == corners_.size() ? 0 : sector + 1;
  }

  // Sector i lies between corners i and i + 1.
  std::size_t sector_of(const Vec2& point) const {
    const auto after = std::upper_bound(angles_.begin(), angles_.end(), pseudo_angle(point));
    return after == angles_.begin() ? corners_.size() - 1
                                    : static_cast<std::size_t>(after - angles_.begin()) - 1;
  }

  double in_sector(std::size_t sector, const Vec2& from, const Vec2& to) const {
    const Vec2 &corner = corners_[sector], side = corners_[next(sector)] - corner;
    const double whole = cross(side, -corner);  // of the origin; above 0
    const double at_from = whole + cross(side, from), at_to = whole + cross(side, to);
    const auto pulled = [&](const Vec2& point, double at) { return whole / (whole - at) * point; };
    if (at_from >= 0 && at_to >= 0) return cross(from, to);
    if (at_from <= 0 && at_to <= 0) return cross(pulled(from, at_from), pulled(to, at_to));
    const Vec2 on_side = from + at_from / (at_from - at_to) * (to - from);
    return at_from > 0 ? cross(from, on_side) + cross(on_side, pulled(to, at_to))
                       : cross(pulled(from, at_from), on_side) + cross(on_side, to);
  }

  Vec2 origin_;
  Points corners_;
  std::vector<double> angles_;
};

}  // namespace

double doubled_area_in_hull(const Points& ring, const Points& hull) {
  const Fan fan(hull);
  double sum = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
    sum += fan.below(ring[i] - fan.origin(), ring[i + 1 == ring.size() ? 0 : i + 1] - fan.origin());
  return sum;
}

// Begins after a vertex that turns; every polygon has one.
Corners::Corners(const Polygon& polygon)
    : polygon_(polygon),
      before_(polygon.size(), none),
      after_(polygon.size(), none),
      is_corner_(polygon.size()),
      begin_(polygon.size()),
      end_(polygon.size()),
      back_(polygon.size(), std::numeric_limits<double>::infinity()),
      on_(polygon.size(), std::numeric_limits<double>::infinity()) {
  std::size_t first = 0;
  while (polygon.turn(first) == Turn::straight) ++first;
  std::vector<std::uint32_t> ends, run;
  std::size_t begin = first;
  do {
    std::size_t end = begin;
    run.clear();
    do {
      run.push_back(static_cast<std::uint32_t>(end));
      end = polygon.next(end);
    } while (polygon.turn(end) == Turn::straight);
    is_corner_[end] = polygon.is_corner(end);
    ends.push_back(static_cast<std::uint32_t>(end));
    for (const std::uint32_t edge : run) {
      begin_[edge] = static_cast<std::uint32_t>(begin);
      end_[edge] = static_cast<std::uint32_t>(end);
      if (polygon.turn(begin) == Turn::convex) before_[edge] = begin_[edge];
      if (polygon.turn(end) == Turn::convex) after_[edge] = end_[edge];
    }
    begin = end;
  } while (begin != first);

  // Each way along the outline twice, since a corner may be beyond where it begins.
  const auto pass = [&](std::vector<double>& way, std::uint32_t at, std::uint32_t beyond) {
    if (is_corner_[at])
      way[at] = 0;
    else if (!polygon.is_notch(at))
      way[at] = length(polygon.vertex(beyond) - polygon.vertex(at)) + way[beyond];
  };
  const std::size_t runs = ends.size();
  for (std::size_t k = 2 * runs; k-- > 0;) pass(on_, ends[k % runs], ends[(k + 1) % runs]);
  for (std::size_t k = 0; k < 2 * runs; ++k) pass(back_, ends[(k + 1) % runs], ends[k % runs]);
}

double Corners::distance_to(const Vec2& point, std::uint32_t edge) const {
  const std::uint32_t begin = begin_[edge], end = end_[edge];
  return std::min(length(polygon_.vertex(begin) - point) + back_[begin],
                  length(polygon_.vertex(end) - point) + on_[end]);
}

namespace {

constexpr std::uint32_t edges_of_leaf = 3;

Box box_of(const std::vector<LineEnds>& lines, std::uint32_t begin, std::uint32_t end) {
  if (begin == end) return {};
  Box box{lines[begin].start, lines[begin].start};
  for (std::uint32_t line = begin; line < end; ++line) {
    for (const Vec2& p : {lines[line].start, lines[line].end}) {
      box.low = componentwise_min(box.low, p);
      box.high = componentwise_max(box.high, p);
    }
  }
  return box;
}

}  // namespace

std::vector<LineEnds> edges_of(const Points& ring) {
  std::vector<LineEnds> lines;
  lines.reserve(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
    lines.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
  return lines;
}

EdgeTree::EdgeTree(const Polygon& polygon) : EdgeTree(edges_of(polygon.vertices())) {}

EdgeTree::EdgeTree(const std::vector<LineEnds>& lines) {
  nodes_.reserve(2 * lines.size() / edges_of_leaf + 2);
  build(lines, 0, static_cast<std::uint32_t>(lines.size()));
}

std::uint32_t EdgeTree::build(const std::vector<LineEnds>& lines, std::uint32_t begin,
                              std::uint32_t end) {
  const auto node = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back({{}, begin, end, 0, 0});
  if (end - begin <= edges_of_leaf) {
    nodes_[node].box = box_of(lines, begin, end);
    return node;
  }
  const std::uint32_t middle = begin + (end - begin) / 2;
  const std::uint32_t left = build(lines, begin, middle), right = build(lines, middle, end);
  const Box &a = nodes_[left].box, &b = nodes_[right].box;
  nodes_[node] = {{componentwise_min(a.low, b.low), componentwise_max(a.high, b.high)},
                  begin,
                  end,
                  left,
                  right};
  return node;
}

}  // namespace evenlift
