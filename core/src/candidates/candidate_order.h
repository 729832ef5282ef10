// Candidate order (algorithm.md, Candidates). A radix sort of 64-bit keys, instead of comparisons
// of candidates, keeps this stage O(K).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The sort key of a candidate, much shorter than the candidate's 104 bytes. The upper bits hold the
// rounded slope: different values are in the right order, but different slopes may share a value.
// The lower bits hold the candidate's number, below max_edge_pairs, to order equal slopes.
using SlopeKey = std::uint64_t;

// The key of a candidate's direction and number. `direction` must point right or count as vertical,
// as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The candidate's number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts keys whose numbers ascend, by an LSD radix sort or, if they are few, by comparisons. O(m).
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates that are sorted by key into candidate order, which is by exact slope. On one line
// the longer comes first; of equally long ones, the one whose right end is farther from C. If these
// distances also tie, the coordinates of the left and the right end decide where they differ by
// more than `near` / 2. So the order of the vertex list never matters, and rounding hardly ever.
// `near` is tau L. O(m), and O(l log l) for each line with l candidates.
void settle_order(std::vector<Candidate>& candidates, double near);

// Puts fewer than max_edge_pairs candidates into candidate order. O(m), plus settle_order().
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

}  // namespace evenlift
