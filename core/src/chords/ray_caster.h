// Finds the boundary points on each of many rays from C.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

class RayCaster {
 public:
  // Stores the polygon relative to C. O(n).
  RayCaster(const Polygon& polygon, const Vec2& centre);

  struct Hit {
    double distance = 0;  // from C
    LiftingPoint point;
  };
  // The boundary points on the ray from C in direction u, nearest first, each listed once. A radial
  // edge contributes those of its end vertices that are in this direction; any other edge
  // contributes at most one point. A vertex whose direction agrees with u within tau counts, even
  // if the boundary only touches the ray there. O(n + k log k) for k points.
  std::vector<Hit> hits(const Vec2& u) const;

  // The farthest point where the ray meets one of `edges`. There must be at least one edge; the ray
  // must meet each edge, and no edge may be radial. If the ray misses an edge only through
  // rounding, it counts as meeting the edge's end. O(number of edges).
  Hit farthest(const Vec2& u, const std::vector<std::uint32_t>& edges) const;

  // The point where the ray meets `edge`, under the same conditions. O(1).
  Hit hit_on(const Vec2& u, std::uint32_t edge) const;

 private:
  struct Edge {
    Vec2 start, end;          // relative to C; counter-clockwise about C unless radial
    double doubled_area = 0;  // cross(start, end), computed before these were rounded
    bool radial = false;
  };
  bool meets_vertex(const Vec2& u, std::uint32_t vertex) const;
  std::uint32_t before(std::uint32_t vertex) const;  // the edge that ends at it

  Vec2 centre_;
  std::vector<Edge> edges_;
  Points vertices_;  // relative to C
};

}  // namespace evenlift
