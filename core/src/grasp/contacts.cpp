#include <algorithm>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/vertex_finder.h"

namespace evenlift {
VertexFinder::VertexFinder(const Polygon& polygon, double near)
    : polygon_(polygon), near_(near), by_x_(lexicographic_order(polygon.vertices())) {}

std::optional<std::uint32_t> VertexFinder::find(const Vec2& p) const {
  auto at = std::lower_bound(by_x_.begin(), by_x_.end(), p.x() - near_,
                             [&](std::uint32_t v, double x) { return polygon_.vertex(v).x() < x; });
  std::optional<std::uint32_t> nearest;
  double least = near_;
  for (; at != by_x_.end() && polygon_.vertex(*at).x() <= p.x() + near_; ++at) {
    const double distance = length(polygon_.vertex(*at) - p);
    if (distance < least || (distance == least && !nearest)) {
      nearest = *at;
      least = distance;
    }
  }
  return nearest;
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
  return find_contacts(polygon, VertexFinder(polygon, near_distance(polygon.diameter())), points);
}

std::vector<Contact> find_contacts(const Polygon& polygon, const VertexFinder& finder,
                                   const std::vector<LiftingPoint>& points) {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    const auto vertex = finder.find(points[i].position);
    if (!vertex) {
      contacts.push_back({points[i].position, points[i].edge, i});
      continue;
    }
    const Turn turn = polygon.turn(*vertex);
    if (turn == Turn::convex) continue;
    const Vec2& position = polygon.vertex(*vertex);
    contacts.push_back({position, *vertex, i});
    if (turn == Turn::reflex)
      contacts.push_back({position, static_cast<std::uint32_t>(polygon.previous(*vertex)), i});
  }
  return contacts;
}

}  // namespace evenlift
