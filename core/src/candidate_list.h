// Candidate order and the merging of duplicates (algorithm.md, Candidates).
#pragma once

#include <vector>

#include "evenlift/candidates.h"

namespace evenlift {

// Puts candidates in candidate order: by slope; on one line the longer first, then the one whose
// right end is farther from C; what still ties by coordinates, so that the order of the input never
// shows. O(K log K).
void sort_by_slope(std::vector<Candidate>& candidates);

// Of candidates (in candidate order) whose ends both agree within `near`, keeps the one with the
// largest ratio, then the first, with the first kind of bisecting, midpoint, vertex that occurs
// among them. Agreement is followed from one to the next. O(K log K) unless many different chords
// lie within `near` of each other.
void merge_duplicates(std::vector<Candidate>& candidates, double near);

}  // namespace evenlift
