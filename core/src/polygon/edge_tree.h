// A tree of boxes. Each node of the tree has the box around consecutive edges.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"

namespace evenlift {

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
