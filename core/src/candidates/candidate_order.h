// Candidate order (algorithm.md, Candidates). A radix sort of 64-bit keys replaces most comparisons
// of candidates, so this stage is O(K), plus O(l log l) for each line with l candidates.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The sort key of a candidate: 8 bytes to move instead of 104. The upper bits of the key hold the
// rounded slope, so keys are in the order of slopes, but different slopes may share a value.
// The lower bits hold the candidate's number, below max_edge_pairs, to order equal values.
using SlopeKey = std::uint64_t;

// The key of a candidate's direction and number. `direction` must point right or count as vertical,
// as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The candidate's number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts m keys by an LSD radix sort or, if there are few, by comparisons. On entry, the numbers in
// the keys must be in ascending order. O(m).
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates that are sorted by key into candidate order, which is by exact slope. On one line
// the longest candidate comes first; of equally long ones, the one whose right end is farthest from
// C. If these distances also tie, the coordinates of the left end decide, then those of the right
// end, if they differ by more than `near` / 2. So the order of the vertex list never matters, and
// rounding hardly ever does. `near` is tau L. O(m), plus O(l log l) for each line with l
// candidates.
void settle_order(std::vector<Candidate>& candidates, double near);

// Returns the candidates, fewer than max_edge_pairs, in candidate order. Costs as much as
// settle_order().
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

}  // namespace evenlift
