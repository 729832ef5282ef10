// Candidate chords: the one of each edge-pair and those between opposite vertices, duplicates
// merged, in order of slope (algorithm.md, Candidates; thesis 3.2, 3.3, 4.2).
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift {

enum class CandidateKind : std::uint8_t { bisecting, midpoint, vertex };

// "bisecting", "midpoint" or "vertex". O(1).
std::string_view name(CandidateKind kind);

struct Candidate {
  Chord chord;
  CandidateKind kind = CandidateKind::bisecting;
  bool between_vertices = false;  // both ends are vertices
  std::uint32_t source = 0;       // of trace_candidates() only: where it came from, see there
  Vec2 direction = Vec2::Zero();  // from r1 to r2, not normalized; chords of one vertex share it
  double length = 0;              // |r1 r2|
};

// A candidate is even if its load ratio is at least 1 - tau. O(1).
bool is_even(const Chord& chord);

// What became of one edge-pair: why it has the candidate that it has, or none.
struct PairVerdict {
  double g0 = 0, g1 = 0;  // |C r_b| / |C r_a| at the beginning and the end of the range
  bool parallel = false;  // g0 and g1 agree within tolerance
  bool bisected = false;  // the bisecting chord lies in the section
  std::optional<Candidate> candidate;
};
PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio);

// The chord between two opposite vertices. It is a candidate if its ratio is at least the minimum.
// O(1).
Candidate opposite_chord(const Polygon& polygon, const Vec2& centre,
                         const OppositeVertices& opposite);

// All candidates in candidate order. `min_ratio` in [0, 1]. Refused if there are more than
// max_edge_pairs edge-pairs and opposite vertices. O(n log n + K log K) at worst for K of them;
// O(n log n + K) where few candidates lie on one line through C.
Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio);

// The same candidates, and where they came from. Sources are numbered: the edge-pairs in the order
// of edge_pairs(), then the opposite vertices in the order of opposite_vertices(). Each candidate
// names as its `source` the one whose chord stands for it.
inline constexpr std::uint32_t no_candidate = ~std::uint32_t{0};
struct TracedCandidates {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> of_source;  // the candidate that it led to, or no_candidate
};
Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio);

}  // namespace evenlift
