// The boundary points on rays from C, for many rays.
#pragma once

#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

class RayCaster {
 public:
  // O(n).
  RayCaster(const Polygon& polygon, const Vec2& centre);

  struct Hit {
    double distance = 0;  // from C
    LiftingPoint point;
  };
  // Boundary points on the ray from C in direction u, nearest first: of a radial edge its end
  // vertices in that direction, of others the one point in their inside or at one end.
  // O(n + k log k).
  std::vector<Hit> hits(const Vec2& u) const;

  // The farthest point on the ray among `edges` (not empty, not radial), which C sees around
  // direction u: a ray that rounding takes past an edge meets its end. O(number of edges).
  Hit farthest(const Vec2& u, const std::vector<std::uint32_t>& edges) const;

  // The point of the ray on one such edge. O(1).
  Hit hit_on(const Vec2& u, std::uint32_t edge) const;

 private:
  struct Edge {
    Vec2 start, end;  // relative to C; counter-clockwise about it, unless radial
    double area = 0;  // start x end, accurate
    bool radial = false;
  };
  Vec2 centre_;
  std::vector<Edge> edges_;
};

}  // namespace evenlift
