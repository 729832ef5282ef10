// Follows the outline from a point in both directions.
#pragma once

#include <algorithm>
#include <cstdint>

#include "evenlift/polygon.h"

namespace evenlift {

// Calls visit(edge, from, to) for each part of an edge within a distance of a point along the
// outline, the nearest first in either direction; `from` is nearer to the point. Ends when visit()
// returns false. O(1) for each part.
template <class Visit>
void walk_outline(const Polygon& polygon, const Vec2& point, std::uint32_t edge, double within,
                  const Visit& visit) {
  for (const bool on : {true, false}) {
    std::size_t now = edge;
    Vec2 at = point;
    double left = within;
    for (std::size_t passed = 0; passed < polygon.size(); ++passed) {
      const std::size_t end = on ? polygon.next(now) : now;
      const Vec2& to = polygon.vertex(end);
      const double way = length(to - at);
      const bool is_last = left < way;
      if (!visit(static_cast<std::uint32_t>(now), at,
                 is_last ? Vec2(at + (left / way) * (to - at)) : to))
        return;
      if (is_last) break;
      left -= way;
      at = to;
      now = on ? end : polygon.previous(now);
    }
  }
}

// The greatest length of the difference between the unit normals of an edge and of the edges within
// a distance of a point on it, along the outline. O(the vertices within it).
inline double greatest_turn(const Polygon& polygon, const Vec2& point, std::uint32_t edge,
                            double within) {
  const auto direction = [&](std::uint32_t e) {
    const Vec2 along = polygon.edge_end(e) - polygon.edge_start(e);
    return Vec2(along / length(along));
  };
  const Vec2 own = direction(edge);
  double greatest = 0;
  walk_outline(polygon, point, edge, within, [&](std::uint32_t other, const Vec2&, const Vec2&) {
    if (other != edge) greatest = std::max(greatest, length(direction(other) - own));
    return true;
  });
  return greatest;
}

}  // namespace evenlift
