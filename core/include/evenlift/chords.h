// How C sees the polygon (algorithm.md, Candidates; thesis 3.3 and 4.2): radial edges,
// vertex-chords, edge-pairs and their sections. Which edges face each other and in which order C
// sees the vertices is decided exactly; only "radial" has a tolerance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/polygon.h"
#include "evenlift/result.h"
#include "evenlift/vec.h"

namespace evenlift {

// A point on the boundary where a robot may stand.
struct LiftingPoint {
  Vec2 position = Vec2::Zero();
  std::uint32_t edge = 0;  // an edge that it lies on
};

// A segment through C whose ends lie on the boundary on opposite sides of C.
struct Chord {
  LiftingPoint r1;   // the left end (lower, if the direction counts as vertical)
  LiftingPoint r2;   // the right end (upper, if vertical)
  double arm1 = 0;   // |C r1| > 0, more precise than from the rounded positions
  double arm2 = 0;   // |C r2| > 0
  double ratio = 1;  // load ratio min(arm1, arm2) / max(arm1, arm2), in (0, 1]
};

// Two non-radial edges of which parts face each other across C: a seen along a range of directions,
// b against it. Counter-clockwise the open range begins where a or b or both begin, and ends where
// one or both end: at the vertices given here, `inside_edge` for the one that is met in its inside.
inline constexpr std::uint32_t inside_edge = ~std::uint32_t{0};
struct EdgePair {
  std::uint32_t a = 0, b = 0;
  std::uint32_t begin_a = inside_edge, begin_b = inside_edge;
  std::uint32_t end_a = inside_edge, end_b = inside_edge;
};

// Two vertices on opposite sides of C, on one line with it within tolerance (tau L). A shape that
// is exactly symmetric and all shapes near it have the same of them, however it lies.
struct OppositeVertices {
  std::uint32_t v = 0, w = 0;  // v < w
};

// Edge-pairs and opposite vertices beyond this number together are refused: they would not fit into
// a browser's memory.
inline constexpr std::uint64_t max_edge_pairs = std::uint64_t{1} << 23;

// For each edge whether its line passes within tolerance (tau L) of C. O(n).
std::vector<bool> radial_edges(const Polygon& polygon, const Vec2& centre);

// A chord that starts at a vertex.
struct VertexChord {
  std::uint32_t vertex = 0;  // where it starts
  std::uint32_t hit_vertex =
      inside_edge;  // the vertex where it ends, if it does not end inside an edge
  Chord chord;
};

// Every chord from a vertex through C, in the order of the rotating line through C, first those
// whose vertex is on its forward side; a chord between two vertices is listed once, at the forward
// one. Radial edges are met at their end vertices only. Refused beyond max_edge_pairs chords.
// O(n log n + k) for k chords.
Result<std::vector<VertexChord>> vertex_chords(const Polygon& polygon, const Vec2& centre);

// Number of edge-pairs, without listing them. O(n log n).
std::uint64_t count_edge_pairs(const Polygon& polygon, const Vec2& centre);

// All edge-pairs, each once, in the order in which their ranges begin. O(n log n + K) for K pairs,
// of a convex polygon O(n) after the sort; refused beyond max_edge_pairs.
Result<std::vector<EdgePair>> edge_pairs(const Polygon& polygon, const Vec2& centre);

// All opposite vertices, each two once, in the order in which C sees the nearer of the two. A
// vertex within tolerance (tau L) of C has no direction and is opposite to none. Refused together
// with the edge-pairs beyond max_edge_pairs. O(n log n) besides the vertices looked at: of each
// vertex v those farther from C within the angle 2 tau L / |C v| of its line.
Result<std::vector<OppositeVertices>> opposite_vertices(const Polygon& polygon, const Vec2& centre);

}  // namespace evenlift
