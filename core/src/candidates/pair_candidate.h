// The candidate of one edge-pair (algorithm.md, Candidates): the cases and their arithmetic.
#pragma once

#include <cstdint>

#include "evenlift/candidates.h"

namespace evenlift {

// A non-radial edge with its ends in the counter-clockwise order in which C sees them.
struct SeenEdge {
  std::uint32_t edge;
  const Vec2& first;
  const Vec2& last;
  double area;  // orient(centre, first, last)
};

// What became of the pair `pair` of a and b. O(1).
PairVerdict examine(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                    const SeenEdge& b, const EdgePair& pair, double min_ratio);

// What is certain from estimates alone, for the many pairs that have no candidate or one of the two
// frequent kinds.
enum class QuickVerdict : std::uint8_t { unsure, none, bisecting, at_begin, at_end };
QuickVerdict examine_quickly(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                             const SeenEdge& b, const EdgePair& pair, double min_ratio);

// C r_a of the chord that C bisects. O(1).
Vec2 bisecting_offset(const Vec2& centre, const SeenEdge& a, const SeenEdge& b);

// The candidate with that offset. O(1).
Candidate bisecting_candidate(const Vec2& centre, std::uint32_t edge_a, std::uint32_t edge_b,
                              const Vec2& offset);

// The chord from a vertex of one edge through C to another edge, at the vertex `opposite` of that
// if it is not inside_edge. O(1).
Candidate vertex_candidate(const Polygon& polygon, const Vec2& centre, std::uint32_t vertex,
                           std::uint32_t edge, const SeenEdge& other, std::uint32_t opposite);

// The vertex-chord at an end of a pair's range, where edge a ends at `vertex_a`, edge b at
// `vertex_b` (inside_edge for one of them that does not). O(1).
struct SectionRim {
  Chord chord;
  Vec2 on_a, on_b;  // its ends
};
SectionRim section_rim(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                       const SeenEdge& b, std::uint32_t vertex_a, std::uint32_t vertex_b);

// Whether a chord's ratio is at least the minimum, within tolerance. O(1).
bool reaches(const Chord& chord, double min_ratio);

// A direction or its opposite, whichever points from r1 to r2. O(1).
Vec2 rightward(const Vec2& direction);

}  // namespace evenlift
