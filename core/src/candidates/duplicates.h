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

// Merges candidates, given in candidate order, whose ends both agree within `near`; a chain of
// agreeing chords is one class. A class keeps a chord between two vertices if it has one, else the
// chord with the largest ratio; the first wins a tie. A chord between two vertices keeps its kind,
// any other gets the first of bisecting, midpoint, vertex in the class. O(m), and O(l log l) for
// each l candidates whose slopes could agree, unless many different chords lie within `near` of
// each other.
MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near);

}  // namespace evenlift
