// The faces of a graph that is drawn in the plane with lines and curves.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/outline.h"

namespace evenlift {

// A line or curve between two nodes.
struct GraphEdge {
  std::size_t from, to;  // nodes
  CurvePiece curve;      // its end is the node `to`
  std::size_t line;      // edges of one straight line have the same number
  std::size_t piece;     // of the drawing
};

// Drops edges that lie on another with the same ends: lines, and curves whose control points are
// within `near`. Of lines the one with the least number stays. What remains does not depend on the
// order. O(edges log edges).
void drop_repeated(std::vector<GraphEdge>& edges, double near);

struct HalfEdge {
  std::size_t edge;
  bool back;  // from `to` to `from`
};

// A bounded face. Its boundary is a simple cycle, counter-clockwise, from its least node by x, then
// y.
struct Face {
  std::vector<HalfEdge> boundary;
};

// The bounded faces, in order of their boundaries. Edges that lead nowhere, and edges whose removal
// would separate the graph, bound none. O(edges log edges).
std::vector<Face> faces_of(const std::vector<GraphEdge>& edges, const Points& nodes);

// The outline of a face. Parts of one straight line become one edge. O(edges of the face).
Outline outline_of(const Face& face, const std::vector<GraphEdge>& edges, const Points& nodes);

}  // namespace evenlift
