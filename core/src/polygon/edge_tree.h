// A tree of boxes over the outline of a polygon: each node contains consecutive edges.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"

namespace evenlift {

// The two ends of an edge, or of any other segment.
struct LineEnds {
  Vec2 start = Vec2::Zero(), end = Vec2::Zero();
};

class EdgeTree {
 public:
  struct Node {
    Box box;
    std::uint32_t begin = 0, end = 0;   // its edges are begin .. end - 1
    std::uint32_t left = 0, right = 0;  // its children; 0 in a leaf, because the root is no child
    bool is_leaf() const { return left == 0; }
  };

  // O(n).
  explicit EdgeTree(const Polygon& polygon);
  // Takes any segments; neighbours should be near each other. Without segments there is one leaf,
  // with no edges. O(n).
  explicit EdgeTree(const std::vector<LineEnds>& lines);

  // The root is node 0.
  const Node& node(std::uint32_t i) const { return nodes_[i]; }

 private:
  std::uint32_t build(const std::vector<LineEnds>& lines, std::uint32_t begin, std::uint32_t end);

  std::vector<Node> nodes_;
};

// The edges of a closed ring, in their order. O(n).
std::vector<LineEnds> edges_of(const Points& ring);

}  // namespace evenlift
