// The merging of duplicate candidates (algorithm.md, Candidates).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

struct MergedCandidates {
  std::vector<Candidate> candidates;  // in candidate order, without duplicates
  std::vector<std::uint32_t> became;  // for each candidate given, the index of the one kept for it
};

// Merges candidates, given in candidate order, whose ends both agree within `near`. Agreement is
// transitive here: a chain of agreeing chords is one class. The chord that is kept of a class is
// one between two vertices, else the one with the largest ratio, else the first. A chord between
// two vertices keeps its kind; any other gets the first kind of bisecting, midpoint, vertex that
// occurs in the class. O(m), and O(l log l) for each l candidates whose slopes could agree, unless
// many different chords lie within `near` of each other.
MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near);

}  // namespace evenlift
