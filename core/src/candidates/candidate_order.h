// Candidate order (algorithm.md, Candidates). A radix sort of 64-bit keys, instead of comparisons
// of candidates, keeps this stage O(K).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The sort key of a candidate, which has 104 bytes. The upper bits hold its rounded slope:
// different keys are in the right order, but different slopes may share a key. The lower bits hold
// its number, below max_edge_pairs, to order equal slopes.
using SlopeKey = std::uint64_t;

// `direction` must point right or count as vertical, as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts keys whose numbers ascend. O(m): an LSD radix sort; a comparison sort for few keys.
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates sorted by key into candidate order: by exact slope; on one line the longer first,
// then the one with the right end farther from C, then by the coordinates of the left and the right
// end, where they differ by more than `near` / 2. So the order of the vertex list never matters,
// and rounding hardly. `near` is tau L. O(m), and O(l log l) for each line with l of them.
void settle_order(std::vector<Candidate>& candidates, double near);

// Puts fewer than max_edge_pairs candidates into candidate order. O(m), plus settle_order().
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

}  // namespace evenlift
