// The faces of a planar graph of lines and curves.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/outline.h"

namespace evenlift {

struct GraphEdge {
  std::size_t from, to;  // nodes
  CurvePiece curve;      // its end is the node `to`
  std::size_t line;      // edges of one straight line have the same number
  std::size_t piece;     // the number of the drawing's piece
};

// Drops edges that lie on another with the same ends: lines, and curves whose control points are
// within `near`. The line with the least number stays. The order does not matter. O(edges log
// edges).
void drop_repeated(std::vector<GraphEdge>& edges, double near);

struct HalfEdge {
  std::size_t edge;
  bool back;  // runs from `to` to `from`
};

// A bounded face as a simple cycle, counter-clockwise, from its least node by x, then y.
struct Face {
  std::vector<HalfEdge> boundary;
};

// The bounded faces, in the order of their boundaries. Edges that lead nowhere, or that alone join
// two parts, bound no face. O(edges log edges).
std::vector<Face> faces_of(const std::vector<GraphEdge>& edges, const Points& nodes);

// The face's outline. Parts of one straight line become one edge. O(edges of the face).
Outline outline_of(const Face& face, const std::vector<GraphEdge>& edges, const Points& nodes);

}  // namespace evenlift
