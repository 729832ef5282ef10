#include <algorithm>
#include <cmath>
#include <utility>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/contact_finder.h"

namespace evenlift {
namespace {

// For so few points, a look at every vertex costs less than sorting the vertices.
constexpr std::size_t few_points = 32;

// The answers of Corners, found for single edges by walking along their runs. O(run).
class CornersNearby {
 public:
  explicit CornersNearby(const Polygon& polygon) : polygon_(polygon) {}

  std::optional<std::uint32_t> before(std::size_t edge) const {
    while (polygon_.turn(edge) == Turn::straight) edge = polygon_.previous(edge);
    return if_convex(edge);
  }
  std::optional<std::uint32_t> after(std::size_t edge) const {
    std::size_t end = polygon_.next(edge);
    while (polygon_.turn(end) == Turn::straight) end = polygon_.next(end);
    return if_convex(end);
  }
  bool is_corner(std::size_t vertex) const { return polygon_.is_corner(vertex); }

 private:
  std::optional<std::uint32_t> if_convex(std::size_t vertex) const {
    if (polygon_.turn(vertex) != Turn::convex) return std::nullopt;
    return static_cast<std::uint32_t>(vertex);
  }

  const Polygon& polygon_;
};

// The nearest vertex to a point within a distance; the first in the list wins a tie. O(1) for each
// vertex that is added.
class NearestVertex {
 public:
  NearestVertex(const Polygon& polygon, const Vec2& point, double within)
      : polygon_(polygon), point_(point), least_(within) {}

  void add(std::uint32_t vertex) {
    const double distance = length(polygon_.vertex(vertex) - point_);
    if (distance > least_) return;
    if (nearest_ && distance == least_ && *nearest_ < vertex) return;
    nearest_ = vertex;
    least_ = distance;
  }

  const std::optional<std::uint32_t>& found() const { return nearest_; }

 private:
  const Polygon& polygon_;
  Vec2 point_;
  double least_;
  std::optional<std::uint32_t> nearest_;
};

// For each point the nearest vertex within a distance, or nothing. O((m + n) log m) for m points,
// if few of them lie within that distance of one another.
std::vector<std::optional<std::uint32_t>> nearest_vertices(const Polygon& polygon,
                                                           const std::vector<LiftingPoint>& points,
                                                           double within) {
  std::vector<std::pair<double, std::size_t>> by_x;
  std::vector<NearestVertex> nearest;
  for (const LiftingPoint& point : points) {
    by_x.push_back({point.position.x(), nearest.size()});
    nearest.emplace_back(polygon, point.position, within);
  }
  std::sort(by_x.begin(), by_x.end());
  const double margin = 2 * within;  // more than the rounding of a difference
  for (std::uint32_t v = 0; v < polygon.size(); ++v) {
    const double x = polygon.vertex(v).x();
    auto at = std::lower_bound(by_x.begin(), by_x.end(), std::pair(x - margin, std::size_t{0}));
    for (; at != by_x.end() && at->first <= x + margin; ++at) nearest[at->second].add(v);
  }
  std::vector<std::optional<std::uint32_t>> found;
  for (const NearestVertex& each : nearest) found.push_back(each.found());
  return found;
}

template <class SomeCorners>
Contact contact_inside(const Polygon& polygon, const SomeCorners& corners, const Vec2& p,
                       std::uint32_t edge, std::uint32_t point) {
  Contact contact{p, edge, point};
  for (const auto& end : {corners.before(edge), corners.after(edge)}) {
    if (!end) continue;
    const double distance = length(polygon.vertex(*end) - p);
    contact.to_end = std::min(contact.to_end, distance);
    if (corners.is_corner(*end)) contact.to_corner = std::min(contact.to_corner, distance);
  }
  return contact;
}

// `vertex_at` returns the nearest vertex within tau L of the point with this index, or nothing.
template <class VertexAt, class SomeCorners>
std::vector<Contact> contacts_of(const Polygon& polygon, const std::vector<LiftingPoint>& points,
                                 const VertexAt& vertex_at, const SomeCorners& corners) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (points[i].edge == beneath) continue;
    const std::optional<std::uint32_t> vertex = vertex_at(i);
    if (!vertex) {
      contacts.push_back(contact_inside(polygon, corners, points[i].position, points[i].edge, i));
      continue;
    }
    const Turn turn = polygon.turn(*vertex);
    const Vec2& position = polygon.vertex(*vertex);
    if (turn == Turn::straight)
      contacts.push_back(contact_inside(polygon, corners, position, *vertex, i));
    // The notch of a reflex vertex keeps the robot in place.
    if (turn == Turn::reflex)
      for (const std::size_t edge : {std::size_t{*vertex}, polygon.previous(*vertex)})
        contacts.push_back({position, static_cast<std::uint32_t>(edge), i});
  }
  return contacts;
}

}  // namespace

ContactFinder::ContactFinder(const Polygon& polygon)
    : polygon_(polygon), near_(near_distance(polygon.diameter())), corners_(polygon) {
  cells_.reserve(polygon.size());
  for (const Vec2& v : polygon.vertices()) cells_.push_back(cell_of(v));
  by_cell_ = sorted_indices(polygon.size(), [&](std::uint32_t a, std::uint32_t b) {
    return cells_[a] != cells_[b] ? cells_[a] < cells_[b] : a < b;
  });
}

ContactFinder::Cell ContactFinder::cell_of(const Vec2& p) const {
  const double side = 4 * near_;
  return {std::floor(p.x() / side), std::floor(p.y() / side)};
}

std::optional<std::uint32_t> ContactFinder::vertex_at(const Vec2& p) const {
  const Cell low = cell_of(p - Vec2(near_, near_)), high = cell_of(p + Vec2(near_, near_));
  NearestVertex nearest(polygon_, p, near_);
  const auto look_into = [&](const Cell& cell) {
    auto at =
        std::lower_bound(by_cell_.begin(), by_cell_.end(), cell,
                         [&](std::uint32_t v, const Cell& wanted) { return cells_[v] < wanted; });
    for (; at != by_cell_.end() && cells_[*at] == cell; ++at) nearest.add(*at);
  };
  look_into(low);
  if (low[1] != high[1]) look_into({low[0], high[1]});
  if (low[0] != high[0]) look_into({high[0], low[1]});
  if (low[0] != high[0] && low[1] != high[1]) look_into(high);
  return nearest.found();
}

std::vector<Contact> ContactFinder::find(const std::vector<LiftingPoint>& points) const {
  return contacts_of(
      polygon_, points, [&](std::size_t i) { return vertex_at(points[i].position); }, corners_);
}

Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge) {
  return inward_normal(polygon.edge_start(edge), polygon.edge_end(edge),
                       polygon.counter_clockwise());
}

Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise) {
  Vec2 along = to - from;
  // The squared length of a shorter edge would underflow.
  if (along.cwiseAbs().maxCoeff() < 0x1p-400) along *= 0x1p600;
  const Vec2 left = left_normal(along) / length(along);
  return counter_clockwise ? left : Vec2(-left);
}

std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points) {
  if (points.size() > few_points) return ContactFinder(polygon).find(points);
  const auto at = nearest_vertices(polygon, points, near_distance(polygon.diameter()));
  return contacts_of(
      polygon, points, [&](std::size_t i) { return at[i]; }, CornersNearby(polygon));
}

}  // namespace evenlift
