// An order of points that depends only on their coordinates.
#pragma once

#include <cstddef>
#include <vector>

#include "curves/outline.h"
#include "evenlift/vec.h"

namespace evenlift {

// Whether a comes before b in order of x, then of y.
inline bool is_before(const Vec2& a, const Vec2& b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

// --- The faces of a planar graph of lines and curves.

struct GraphEdge {
  std::size_t from, to;  // indices of nodes
  CurvePiece curve;      // its end is the node `to`
  std::size_t line;      // edges of one straight line have the same number
  std::size_t piece;     // its piece, or a piece that it joins: an index in the list of join()
};

// Drops each edge that repeats another between the same nodes. A straight line repeats any other
// straight line there, and a curve repeats a curve of its kind if their control points are within
// `near` of each other. Of repeated lines, the one with the least `line` stays. The order of the
// edges does not matter. O(edges log edges) if few curves join the same two nodes.
void drop_repeated(std::vector<GraphEdge>& edges, double near);

struct HalfEdge {
  std::size_t edge;
  bool back;  // runs from `to` to `from`
};

// A bounded face as a simple counter-clockwise cycle, from the corner that is first by x, then y.
struct Face {
  std::vector<HalfEdge> boundary;
};

// The bounded faces, in the order of the first nodes of their boundaries. `nodes` must be in order
// of x, then y. Edges that lead nowhere, and edges that are the only link between two parts of the
// graph, bound no face. O(edges log edges).
std::vector<Face> faces_of(const std::vector<GraphEdge>& edges, const Points& nodes);

// The face's outline. Parts of one straight line become one edge. O(edges of the face).
Outline outline_of(const Face& face, const std::vector<GraphEdge>& edges, const Points& nodes);

}  // namespace evenlift
