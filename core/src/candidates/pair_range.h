// The range of an edge-pair (algorithm.md, Ranges): where along it chords are even enough, and the two
// candidates that it adds.
#pragma once

#include <optional>

#include "candidates/pair_candidate.h"

namespace evenlift {

// See range_of() (candidates.h). O(1).
std::optional<PairRange> find_range(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                                    const SeenEdge& b, const EdgePair& pair, double min_ratio);

// Whether all chords of the range agree within `near`, so that it adds no candidates. O(1).
bool is_one_place(const PairRange& range, double near);

// The candidate at a place x of the range. O(1).
Candidate range_candidate(const Vec2& centre, const PairRange& range, double x);

}  // namespace evenlift
