// How C sees the polygon (section 2 of algorithm.md; thesis 3.3, 4.2). Exact tests decide which
// edges face each other, and in which order C sees the vertices. The tests for radial edges and
// opposite vertices have a tolerance of tau L.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// A point where a robot may lift: on the boundary, or inside the object.
struct LiftingPoint {
  Vec2 position;
  std::uint32_t edge = 0;  // an edge on which it lies, or `beneath`
};

// The value of LiftingPoint::edge for a point inside the object. A robot there lifts the object but
// touches no edge (supports.h).
inline constexpr std::uint32_t beneath = ~std::uint32_t{0};

// The positions of the points, in the same order. O(points).
Points positions(const std::vector<LiftingPoint>& points);

// A segment through C with both ends on the boundary, on opposite sides of C.
struct Chord {
  LiftingPoint r1;   // the left end (lower, if the direction counts as vertical)
  LiftingPoint r2;   // the right end (upper)
  double arm1 = 0;   // |C r1| > 0, more precise than the rounded positions would give
  double arm2 = 0;   // |C r2| > 0
  double ratio = 1;  // min(arm1, arm2) / max(arm1, arm2), in (0, 1]
};

// The value of a vertex index if an edge is met in its interior, not at a vertex. With a
// std::optional instead, each of up to eight million edge pairs would be 16 bytes larger.
inline constexpr std::uint32_t inside_edge = ~std::uint32_t{0};

// Two non-radial edges that face each other across C: for an open range of directions u, the ray
// from C along u meets `a` and the ray along -u meets `b`. Counter-clockwise, the range begins at
// the vertices `begin_a` of `a` and `begin_b` of `b`, and ends at `end_a` and `end_b`. Where it
// begins or ends in the interior of an edge, the value for this edge is inside_edge.
struct EdgePair {
  std::uint32_t a = 0, b = 0;
  std::uint32_t begin_a = inside_edge, begin_b = inside_edge;
  std::uint32_t end_a = inside_edge, end_b = inside_edge;
};

// Two vertices on opposite sides of C whose line passes within tau L of C. With this tolerance,
// rounding does not decide which vertices of a symmetric shape are opposite.
struct OppositeVertices {
  std::uint32_t v = 0, w = 0;  // v < w
};

// The greatest number of edge pairs and pairs of opposite vertices together. More would not fit
// into a browser's memory.
inline constexpr std::uint64_t max_edge_pairs = std::uint64_t{1} << 23;

// For each edge, whether its line passes within tau L of C. O(n log n).
std::vector<bool> radial_edges(const Polygon& polygon, const Vec2& centre);

// A chord that starts at a vertex.
struct VertexChord {
  std::uint32_t vertex = 0;                // where it starts
  std::uint32_t hit_vertex = inside_edge;  // the vertex where it ends, or inside_edge
  Chord chord;
};

// All chords from a vertex through C, in the order in which a line that turns about C meets the
// vertices where they start. In each direction, vertices on the line's forward half come first. A
// chord between two vertices is listed once, from the vertex on the forward half. Radial edges are
// met at their ends only. More than max_edge_pairs chords are an error. O(n log n + k) for k
// chords.
Result<std::vector<VertexChord>> vertex_chords(const Polygon& polygon, const Vec2& centre);

// The number of edge pairs. O(n log n).
std::uint64_t count_edge_pairs(const Polygon& polygon, const Vec2& centre);

// All edge pairs, in the order in which their ranges begin. More than max_edge_pairs are an error.
// O(n log n + K) for K pairs. If the polygon is convex, there are O(n) pairs.
Result<std::vector<EdgePair>> edge_pairs(const Polygon& polygon, const Vec2& centre);

// All pairs of opposite vertices, in the order in which C sees the nearer vertex of each pair. A
// vertex within tau L of C belongs to no pair. It is an error if these pairs and the edge pairs
// together exceed max_edge_pairs. O(n log n + k). Here k is the number of pairs of vertices v and w
// such that w is farther from C, and the sine of the angle between the lines C v and C w is at most
// 2 tau L / |C v|.
Result<std::vector<OppositeVertices>> opposite_vertices(const Polygon& polygon, const Vec2& centre);

}  // namespace evenlift
