// Finds the edges near an edge, by a tree of boxes.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "evenlift/plane.h"
#include "polygon/edge_tree.h"

namespace evenlift {

// A rectangle: the points `start` + x `along` + y `outward`, with x and y in these ranges.
struct Surrounding {
  Vec2 start, along, outward;
  double x_low, x_high, y_low, y_high;
};

class NearEdges {
 public:
  // Edges that are neighbours in the list should be near each other. O(n).
  explicit NearEdges(std::vector<LineEnds> edges) : edges_(std::move(edges)), tree_(edges_) {}

  const LineEnds& edge(std::uint32_t i) const { return edges_[i]; }

  // Visits the edges whose boxes meet the rectangle, and perhaps a few others, in ascending order.
  // O(log n) for each edge that meets the rectangle, if the edges do not wind much.
  template <class Visit>
  void for_each(const Surrounding& around, Visit&& visit) const {
    descend(around, 0, visit);
  }

 private:
  template <class Visit>
  void descend(const Surrounding& around, std::uint32_t index, Visit& visit) const {
    const EdgeTree::Node& node = tree_.node(index);
    if (!meets(around, node.box)) return;
    if (node.is_leaf()) {
      for (std::uint32_t edge = node.begin; edge < node.end; ++edge)
        if (meets(around, bounding_box({edges_[edge].start, edges_[edge].end}))) visit(edge);
      return;
    }
    descend(around, node.left, visit);
    descend(around, node.right, visit);
  }

  static bool meets(const Surrounding& around, const Box& box);

  std::vector<LineEnds> edges_;
  EdgeTree tree_;
};

}  // namespace evenlift
