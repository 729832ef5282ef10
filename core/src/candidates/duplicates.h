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
// A chain of agreeing chords is one class. A class keeps a chord between two vertices if it has
// one, otherwise the chord with the largest ratio; the first wins a tie. A chord between two
// vertices keeps its kind, and any other gets the first of the kinds bisecting, midpoint, vertex
// and range that occurs in its class. O(m), plus O(l log l) for each group of l candidates whose
// slopes could agree, unless many different chords lie within `near` of each other.
MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near);

}  // namespace evenlift
