// Candidate order (algorithm.md, Candidates): by slope, and on one line by length and right end.
// Sorting 64-bit keys by radix instead of comparing candidates keeps this stage O(K).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// The sort key of a candidate, which itself has 104 bytes. The upper bits hold the slope of its
// direction, rounded so that different keys are in the right order but different slopes may have
// equal keys. The lower bits hold its number, below max_edge_pairs, so that equal slopes stay in
// order of their numbers.
using SlopeKey = std::uint64_t;

// `direction` must point right or count as vertical, as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts keys whose numbers ascend. O(m): an LSD radix sort; a comparison sort if there are few.
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates that are in the order of their keys into candidate order: by exact slope; on one
// line the longer first, then the one whose right end is farther from C, then by coordinates of the
// left and the right end, where they differ by more than `near` / 2, so that the order of the
// vertex list never matters, and rounding hardly. `near` is tau L. O(m), and O(l log l) for each
// line with l of them.
void settle_order(std::vector<Candidate>& candidates, double near);

// Candidates found in any order, fewer than max_edge_pairs of them, in candidate order. O(m), and
// what settle_order() takes.
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

}  // namespace evenlift
