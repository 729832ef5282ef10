// Candidate order (algorithm.md, Candidates): by slope, and on one line by length and right end.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// What is sorted in place of a candidate of 104 bytes: the slope of its direction, rounded without
// ever changing the order (equal keys may still differ), in the upper bits; its number, below
// max_edge_pairs, in the lower. So candidates of equal keys stay in order of their numbers.
using SlopeKey = std::uint64_t;

// `direction` points right, or counts as vertical, as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// O(m): four or five passes over the keys; a comparison sort for few.
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates that stand in the order of their keys into candidate order: by exact slope; on
// one line the longer first, then the one whose right end is farther from C; what still ties by
// coordinates, so that the order of the input never shows. O(m) and O(l log l) for each line with l
// of them.
void settle_order(std::vector<Candidate>& candidates);

}  // namespace evenlift
