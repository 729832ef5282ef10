// The merging of duplicate candidates (algorithm.md, Candidates).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

struct MergedCandidates {
  std::vector<Candidate> candidates;  // in candidate order, without duplicates
  std::vector<std::uint32_t> became;  // for each given candidate, the index of the kept one
};

// Merges candidates whose ends both agree within `near`; the candidates must be in candidate order.
// Chords that agree directly, or through a chain of other chords, form one class. A class keeps its
// chord between two vertices or, if it has no such chord, the chord with the largest ratio; of
// several, the first. A kept chord between two vertices keeps its kind. Any other kept chord gets
// the first of the kinds bisecting, midpoint, vertex and range that occurs in its class. O(m) for m
// candidates, plus O(l log l) for each group of l candidates whose slopes could agree. The cost is
// greater if many different chords lie within `near` of each other.
MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near);

}  // namespace evenlift
