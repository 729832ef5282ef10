// Clips rings, closed polygonal lines, by half-planes (I. E. Sutherland and G. W. Hodgman,
// Reentrant polygon clipping, 1974).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"
#include "evenlift/vec.h"

namespace evenlift {

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

}  // namespace evenlift
