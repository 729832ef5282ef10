// Candidate chords: the one of each edge-pair, duplicates merged, in order of slope (algorithm.md,
// Candidates; thesis 3.2, 3.3, 4.2).
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
  std::uint32_t pair = 0;  // where find_candidates was asked to note it: index in edge_pairs()
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

// All candidates in candidate order. `min_ratio` in [0, 1]. Refused if there are more than
// max_edge_pairs pairs. O(n log n + K) for K edge-pairs, and O(l log l) for each line through C
// with l candidates on it. With `of_pairs`, notes for each pair in the order of edge_pairs() the
// index of the candidate that it led to, or no_candidate; and in each candidate its pair.
inline constexpr std::uint32_t no_candidate = ~std::uint32_t{0};
Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio,
                                               std::vector<std::uint32_t>* of_pairs = nullptr);

}  // namespace evenlift
