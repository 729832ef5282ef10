// Finds the edges near an edge, with a tree of boxes over the outline.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"
#include "polygon/edge_tree.h"

namespace evenlift {

// A rectangle: the points start + x along + y outward with x and y in these ranges.
struct Surrounding {
  Vec2 start, along, outward;
  double x_low, x_high, y_low, y_high;
};

class NearEdges {
 public:
  // The polygon must outlive it. O(n).
  explicit NearEdges(const Polygon& polygon) : polygon_(polygon), tree_(polygon) {}

  // Calls visit(edge) for each edge whose box meets the rectangle, and perhaps a few others, by
  // ascending edge. O(log n) for each edge that meets it, if the outline does not wind much.
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
        if (meets(around, bounding_box({polygon_.edge_start(edge), polygon_.edge_end(edge)})))
          visit(edge);
      return;
    }
    descend(around, node.left, visit);
    descend(around, node.right, visit);
  }

  static bool meets(const Surrounding& around, const Box& box);

  const Polygon& polygon_;
  EdgeTree tree_;
};

}  // namespace evenlift
