#include <algorithm>
#include <cmath>
#include <optional>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/contact_finder.h"

namespace evenlift {
namespace {

// Up to this many points, looking at every vertex costs less than sorting them.
constexpr std::size_t few_points = 32;

// The convex vertices at the ends of an edge's straight run (polygon/corners.h). Without `corners`,
// they are found by walking along the run, in O(run).
struct RunEnds {
  RunEnds(const Polygon& polygon, const Corners* corners, std::uint32_t edge) {
    if (corners) {
      before = corners->before(edge);
      after = corners->after(edge);
      return;
    }
    std::size_t begin = edge, end = polygon.next(edge);
    while (polygon.turn(begin) == Turn::straight) begin = polygon.previous(begin);
    while (polygon.turn(end) == Turn::straight) end = polygon.next(end);
    if (polygon.turn(begin) == Turn::convex) before = static_cast<std::uint32_t>(begin);
    if (polygon.turn(end) == Turn::convex) after = static_cast<std::uint32_t>(end);
  }
  std::optional<std::uint32_t> before, after;
};

// The nearest vertex to a point within a distance; the first in the list wins a tie. O(1) for each
// vertex that is added.
class NearestVertex {
 public:
  NearestVertex(const Polygon& polygon, const Vec2& point, double within)
      : polygon_(polygon), point_(point), least_(within) {}

  // False only for a place that is too far away. The factor 2 exceeds the rounding of a difference.
  bool may_be(const Vec2& place) const { return std::fabs(place.x - point_.x) <= 2 * least_; }

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

// O(m n) for m points.
std::vector<NearestVertex> nearest_vertices(const Polygon& polygon,
                                            const std::vector<LiftingPoint>& points,
                                            double within) {
  std::vector<NearestVertex> nearest;
  nearest.reserve(points.size());
  for (const LiftingPoint& point : points) nearest.push_back({polygon, point.position, within});
  for (std::uint32_t v = 0; v < polygon.size(); ++v)
    for (NearestVertex& each : nearest)
      if (each.may_be(polygon.vertex(v))) each.add(v);
  return nearest;
}

Contact contact_inside(const Polygon& polygon, const Corners* corners, const Vec2& p,
                       std::uint32_t edge, std::uint32_t point) {
  Contact contact{p, edge, point};
  const RunEnds ends(polygon, corners, edge);
  for (const auto& end : {ends.before, ends.after}) {
    if (!end) continue;
    const double distance = length(polygon.vertex(*end) - p);
    contact.to_end = std::min(contact.to_end, distance);
    if (corners ? corners->is_corner(*end) : polygon.is_corner(*end))
      contact.to_corner = std::min(contact.to_corner, distance);
  }
  return contact;
}

std::vector<Contact> contacts_of(const Polygon& polygon, const std::vector<LiftingPoint>& points,
                                 const std::vector<NearestVertex>& nearest,
                                 const Corners* corners) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (points[i].edge == beneath) continue;
    const std::optional<std::uint32_t>& vertex = nearest[i].found();
    if (!vertex) {
      contacts.push_back(contact_inside(polygon, corners, points[i].position, points[i].edge, i));
      continue;
    }
    const Turn turn = polygon.turn(*vertex);
    const Vec2& position = polygon.vertex(*vertex);
    if (turn == Turn::straight)
      contacts.push_back(contact_inside(polygon, corners, position, *vertex, i));
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
  return {std::floor(p.x / side), std::floor(p.y / side)};
}

template <class Take>
void ContactFinder::each_vertex_near(const Vec2& p, Take take) const {
  const Cell low = cell_of(p - Vec2(near_, near_)), high = cell_of(p + Vec2(near_, near_));
  const auto look_into = [&](const Cell& cell) {
    auto at =
        std::lower_bound(by_cell_.begin(), by_cell_.end(), cell,
                         [&](std::uint32_t v, const Cell& wanted) { return cells_[v] < wanted; });
    for (; at != by_cell_.end() && cells_[*at] == cell; ++at) take(*at);
  };
  look_into(low);
  if (low[1] != high[1]) look_into({low[0], high[1]});
  if (low[0] != high[0]) look_into({high[0], low[1]});
  if (low[0] != high[0] && low[1] != high[1]) look_into(high);
}

std::vector<Contact> ContactFinder::find(const std::vector<LiftingPoint>& points) const {
  std::vector<NearestVertex> nearest;
  nearest.reserve(points.size());
  for (const LiftingPoint& point : points) {
    nearest.push_back({polygon_, point.position, near_});
    each_vertex_near(point.position, [&](std::uint32_t v) { nearest.back().add(v); });
  }
  return contacts_of(polygon_, points, nearest, &corners_);
}

Vec2 inward_normal(const Polygon& polygon, std::uint32_t edge) {
  return inward_normal(polygon.edge_start(edge), polygon.edge_end(edge),
                       polygon.counter_clockwise());
}

Vec2 inward_normal(const Vec2& from, const Vec2& to, bool counter_clockwise) {
  Vec2 along = to - from;
  // The squared length of a shorter edge would underflow.
  if (max_norm(along) < 0x1p-400) along *= 0x1p600;
  const Vec2 left = left_normal(along) / length(along);
  return counter_clockwise ? left : Vec2(-left);
}

std::vector<Contact> contacts(const Polygon& polygon, const std::vector<LiftingPoint>& points) {
  if (points.size() > few_points) return ContactFinder(polygon).find(points);
  const double near = near_distance(polygon.diameter());
  return contacts_of(polygon, points, nearest_vertices(polygon, points, near), nullptr);
}

}  // namespace evenlift
