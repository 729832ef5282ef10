// The arithmetic of chords from a vertex through C, both for vertex-chords and for the ends of
// sections. An edge's section in an edge pair is the part of the edge where the pair's chords end
// (docs/algorithm.md, Edge pairs).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift {

// The point C + factor (C - w), where the ray from C away from vertex w meets the line of an edge.
struct Across {
  double factor = 0;  // > 0, with a relative error of about 2^-45; exactly 1 if C bisects the chord
  int compare_to_one = 0;  // -1, 0, 1: the factor is below, equal to or above 1; exact
};

// Looks from w across C to the edge b c. The ray from C away from w must meet this edge, which must
// be counter-clockwise about C and not radial. `doubled_area` must be orient(centre, b, c). O(1).
Across look_across(const Vec2& centre, const Vec2& w, const Vec2& b, const Vec2& c,
                   double doubled_area);

// Estimates the factor of look_across() by a few multiplications, with a relative error below
// 2^-33. Returns nothing if plain doubles are not that accurate. O(1).
std::optional<double> estimate_across(const Vec2& centre, const Vec2& w, const Vec2& b,
                                      const Vec2& c, double doubled_area);

// The chord from vertex w, on `edge_w`, through C to the point `across` on `edge_hit`. That point
// is the vertex `hit`, unless `hit` is inside_edge.
Chord chord_from_vertex(const Polygon& polygon, const Vec2& centre, std::uint32_t w,
                        std::uint32_t edge_w, const Across& across, std::uint32_t edge_hit,
                        std::uint32_t hit);

// The chord with these ends, in the order that Chord requires. `direction` points from `behind` to
// `ahead`.
Chord order_ends(const LiftingPoint& ahead, double arm_ahead, const LiftingPoint& behind,
                 double arm_behind, const Vec2& direction);

// Whether a direction points from r1 to r2, that is, to the right, or upward if the direction
// counts as vertical.
bool points_right(const Vec2& direction);

// The shorter of two positive lengths divided by the longer.
double load_ratio(double arm1, double arm2);

// Whether the ends of two chords agree within the distance `near`, in either order.
bool same_chord(const Chord& a, const Chord& b, double near);

// --- Finds the boundary points on each of many rays from C.

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
