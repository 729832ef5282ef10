// Candidate order (algorithm.md, Candidates): by slope, and on one line by length and right end. A
// radix sort of 64-bit keys, instead of comparisons of candidates, keeps this stage O(K).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The sort key of a candidate; the candidate itself has 104 bytes. The upper bits hold the slope of
// its direction, rounded: different keys are in the right order, but different slopes may have
// equal keys. The lower bits hold its number, below max_edge_pairs, so that equal slopes stay in
// order of their numbers.
using SlopeKey = std::uint64_t;

// `direction` must point right or count as vertical, as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts keys whose numbers ascend. O(m): an LSD radix sort; a comparison sort for few keys.
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates sorted by their keys into candidate order: by exact slope; on one line by length,
// the longer first, then by the distance of the right end from C, the greater first, then by the
// coordinates of the left and the right end, where they differ by more than `near` / 2. So the
// order of the vertex list never matters, and rounding hardly matters. `near` is tau L. O(m), and
// O(l log l) for each line with l of them.
void settle_order(std::vector<Candidate>& candidates, double near);

// Puts candidates found in any order, fewer than max_edge_pairs of them, into candidate order.
// O(m), plus the cost of settle_order().
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

}  // namespace evenlift
