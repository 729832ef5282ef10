// Corners of a hull that only rounding makes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/polygon.h"
#include "evenlift/vec.h"

namespace evenlift {

// Whether only rounding makes a corner between two others: it is within `flat` of either, or on the
// side between them, within tau of its length. O(1).
bool is_straight_corner(const Vec2& before, const Vec2& corner, const Vec2& after, double flat);

// --- Follows the outline from a point in both directions.

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

// --- The convex vertices at the ends of an outline's straight runs, which of them are corners
// (Polygon::is_corner), and how far corners are along the outline. Straight vertices join their
// edges into one run, so extra vertices on a straight side change nothing.

class Corners {
 public:
  // The polygon must outlive this object. O(n).
  explicit Corners(const Polygon& polygon);

  // The vertex where the run of an edge begins or ends, in the order of the vertices; nullopt if
  // this vertex is reflex. O(1).
  std::optional<std::uint32_t> before(std::uint32_t edge) const { return some(before_[edge]); }
  std::optional<std::uint32_t> after(std::uint32_t edge) const { return some(after_[edge]); }

  // Whether the vertex is a corner (Polygon::is_corner). O(1).
  bool is_corner(std::uint32_t vertex) const { return is_corner_[vertex]; }

  // The distance along the outline from a point on an edge to the nearest corner, in either direction
  // and past vertices that turn little; infinite if there is none, or none before the next notch
  // (Polygon::is_notch). O(1).
  double distance_to(const Vec2& point, std::uint32_t edge) const;

 private:
  static constexpr std::uint32_t none = ~std::uint32_t{0};
  static std::optional<std::uint32_t> some(std::uint32_t vertex) {
    return vertex == none ? std::nullopt : std::optional(vertex);
  }

  const Polygon& polygon_;
  std::vector<std::uint32_t> before_, after_;  // by edge
  std::vector<bool> is_corner_;                // by vertex
  std::vector<std::uint32_t> begin_, end_;     // by edge: the ends of its run
  std::vector<double> back_,
      on_;  // from the end of a run to the nearest corner before and after it
};

}  // namespace evenlift
