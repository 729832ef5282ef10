// The merging of duplicate candidates (algorithm.md, Candidates).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// Of candidates (in candidate order) whose ends both agree within `near`, keeps the one with the
// largest ratio, then the first, with the first kind of bisecting, midpoint, vertex that occurs
// among them. Agreement is followed from one to the next. O(m), and O(l log l) for each l of them
// whose slopes could agree, unless many different chords lie within `near` of each other.
// With `of_pairs`, puts there for the pair of each candidate given (Candidate::pair) the index of
// the one that stands for it afterwards.
void merge_duplicates(std::vector<Candidate>& candidates, double near,
                      std::vector<std::uint32_t>* of_pairs = nullptr);

}  // namespace evenlift
