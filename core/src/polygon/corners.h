// Walks along outlines and their corners, clipping, areas in hulls, trees of edges, sweeps over rings.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "evenlift/document.h"
#include "evenlift/polygon.h"
#include "evenlift/vec.h"
#include "exact/sorted_indices.h"

namespace evenlift {

// --- Corners of a hull that only rounding makes.

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

// --- Clips rings, closed polygonal lines, by half-planes (I. E. Sutherland and G. W. Hodgman,
// Reentrant polygon clipping, 1974).

// The part of the ring on or to the left of the line a -> b. Parts of a ring that is not convex may
// be connected by overlapping edges along the line; the signed area is still correct. O(m) for m
// vertices.
Points clip_left(const Points& ring, const Vec2& a, const Vec2& b);

// Clips by the line through `from` along `direction`. If two close points were moved, rounding may
// have turned their line; then pass the difference of the original points as `direction`. O(m).
Points clip_left_of_ray(const Points& ring, const Vec2& from, const Vec2& direction);

// The signed area of the part of the ring to the left of both a -> b and b -> c. The function clips
// twice in one pass, without storing the result. O(m).
double area_left_of_both(const Points& ring, const Vec2& a, const Vec2& b, const Vec2& c);

// --- The area of the part of an object in a convex polygon with many corners.

// Twice the area of the part of a closed ring in a convex, counter-clockwise polygon with an area,
// negative for a clockwise ring. Each edge is compared only with the sides of the polygon between
// the directions of its ends, seen from inside the polygon. So for a ring whose edges hardly
// overlap, seen from there, n edges and h sides take O(n log h + h); clipping takes O(n h) always.
double doubled_area_in_hull(const Points& ring, const Points& hull);

// --- A tree of boxes. Each node of the tree has the box around consecutive edges.

// The ends of an edge or of any other segment.
struct LineEnds {
  Vec2 start, end;
};

class EdgeTree {
 public:
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;   // edges begin .. end - 1
    std::uint32_t left = 0, right = 0;  // children; 0 in a leaf, as the root is never a child
    bool is_leaf() const { return left == 0; }
  };

  // O(n).
  explicit EdgeTree(const Polygon& polygon);
  // Makes the tree of any segments; neighbours in the list should be near each other. If there are
  // no segments, the tree is one leaf without edges. O(n).
  explicit EdgeTree(const std::vector<LineEnds>& lines);

  // Node 0 is the root.
  const Node& node(std::uint32_t i) const { return nodes_[i]; }

 private:
  std::uint32_t build(const std::vector<LineEnds>& lines, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
};

// The edges of a closed ring, in order. O(n).
std::vector<LineEnds> edges_of(const Points& ring);

// --- The least size of coordinates.

// Whether a coordinate is not 0 but nearer to 0 than is accepted. Differences of accepted
// coordinates are 0 or at least 1e-116 in size, so lengths, areas and moments of even the thinnest
// object stay far from underflow. O(1).
inline bool is_too_near_to_0(double coordinate) {
  return coordinate != 0 && std::fabs(coordinate) < min_coordinate;
}
inline bool is_too_near_to_0(const Vec2& v) {
  return is_too_near_to_0(v.x) || is_too_near_to_0(v.y);
}

// --- Finds edges of rings that cross or touch, and for each ring the innermost ring around it. All
// decisions are exact.

// Rings in one list of vertices: ring r ends before ends[r]. Edge i runs from vertex i to the next
// vertex of its ring.
struct Rings {
  Points vertices;
  std::vector<std::size_t> ends;
  std::vector<bool> counter_clockwise;  // by ring; needed only if there is more than one ring
  std::size_t size() const { return ends.size(); }
  std::size_t begin(std::size_t ring) const { return ring == 0 ? 0 : ends[ring - 1]; }
};

struct RingSweep {
  // Two edges with a common point, the smaller index first; nullopt if there are no such edges. The
  // vertex that neighbours share does not count.
  std::optional<std::pair<std::size_t, std::size_t>> crossing;
  // For each ring, the innermost ring around it; nullopt if there is none. The list is filled only
  // if there is no crossing.
  std::vector<std::optional<std::size_t>> around;
};

// The sweep of M. I. Shamos and D. Hoey (Geometric intersection problems, 1976) with exact
// predicates. The vertices must be distinct. `order` is their lexicographic_order(). O(n log n).
RingSweep sweep(const Rings& rings, const SortedIndices& order);

}  // namespace evenlift
