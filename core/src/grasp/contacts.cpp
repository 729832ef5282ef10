#include <algorithm>
#include <cmath>

#include "evenlift/closure.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "grasp/contact_finder.h"

namespace evenlift {
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

// The nearest vertex within tau L; the first in the list wins a tie.
std::optional<std::uint32_t> ContactFinder::vertex_at(const Vec2& p) const {
  const Cell low = cell_of(p - Vec2(near_, near_)), high = cell_of(p + Vec2(near_, near_));
  std::optional<std::uint32_t> nearest;
  double least = near_;
  const auto look_into = [&](const Cell& cell) {
    auto at =
        std::lower_bound(by_cell_.begin(), by_cell_.end(), cell,
                         [&](std::uint32_t v, const Cell& wanted) { return cells_[v] < wanted; });
    for (; at != by_cell_.end() && cells_[*at] == cell; ++at) {
      const double distance = length(polygon_.vertex(*at) - p);
      if (distance > least) continue;
      if (nearest && distance == least && *nearest < *at) continue;
      nearest = *at;
      least = distance;
    }
  };
  look_into(low);
  if (low[1] != high[1]) look_into({low[0], high[1]});
  if (low[0] != high[0]) look_into({high[0], low[1]});
  if (low[0] != high[0] && low[1] != high[1]) look_into(high);
  return nearest;
}

Contact ContactFinder::contact_inside(const Vec2& p, std::uint32_t edge,
                                      std::uint32_t point) const {
  Contact contact{p, edge, point};
  for (const auto& end : {corners_.before(edge), corners_.after(edge)}) {
    if (!end) continue;
    const double distance = length(polygon_.vertex(*end) - p);
    contact.to_end = std::min(contact.to_end, distance);
    if (corners_.is_corner(*end)) contact.to_corner = std::min(contact.to_corner, distance);
  }
  return contact;
}

std::vector<Contact> ContactFinder::find(const std::vector<LiftingPoint>& points) const {
  std::vector<Contact> contacts;
  for (std::uint32_t i = 0; i < points.size(); ++i) {
    if (points[i].edge == beneath) continue;
    const auto vertex = vertex_at(points[i].position);
    if (!vertex) {
      contacts.push_back(contact_inside(points[i].position, points[i].edge, i));
      continue;
    }
    const Turn turn = polygon_.turn(*vertex);
    const Vec2& position = polygon_.vertex(*vertex);
    if (turn == Turn::straight) contacts.push_back(contact_inside(position, *vertex, i));
    // The notch of a reflex vertex keeps the robot in place.
    if (turn == Turn::reflex)
      for (const std::size_t edge : {std::size_t{*vertex}, polygon_.previous(*vertex)})
        contacts.push_back({position, static_cast<std::uint32_t>(edge), i});
  }
  return contacts;
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
  return ContactFinder(polygon).find(points);
}

}  // namespace evenlift
