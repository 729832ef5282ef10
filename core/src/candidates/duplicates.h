// The merging of duplicate candidates (algorithm.md, Candidates).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// Of candidates (in candidate order) whose ends both agree within `near` one stands: one between
// two vertices, else the one with the largest ratio, then the first. A chord between two vertices
// keeps its kind; another one gets the first kind of bisecting, midpoint, vertex that occurs among
// them. Agreement is transitive here: chains of agreeing chords are one class. Returns for each
// candidate given the index of the one that stands for it afterwards. O(m), and O(l log l) for each
// l of them whose slopes could agree, unless many different chords lie within `near` of each other.
std::vector<std::uint32_t> merge_duplicates(std::vector<Candidate>& candidates, double near);

}  // namespace evenlift
