// The range of an edge pair (algorithm.md, Ranges), in which chords meet the minimum ratio, and the
// two candidates that the range adds.
#pragma once

#include <optional>

#include "candidates/pair_candidate.h"
#include "evenlift/stands.h"
#include "polygon/corners.h"

namespace evenlift {

// Returns the same as range_of() (candidates.h), given the two edges as C sees them. O(1).
std::optional<PairRange> find_range(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                                    const SeenEdge& b, const EdgePair& pair, double min_ratio);

// Whether all chords of the range agree within `near`; if so, the range adds no candidates. O(1).
bool is_one_place(const PairRange& range, double near);

// The candidate at the place x of the range (see PairRange). O(1).
Candidate range_candidate(const Vec2& centre, const PairRange& range, double x);

// The distance that range candidates keep from corners, and the data to measure it.
struct FromCorners {
  const Polygon& polygon;
  const Corners& corners;
  double clear = 0;
  const Stands* stands = nullptr;  // if set, contacts rather than lifting points keep it
};

// The part of the range in which both robots are at least `clear` from the corners of their edges,
// within tau L. Returns nothing if at most one place is left, or if `clear` is 0. O(1).
std::optional<PairRange> clear_part(const FromCorners& from, const Vec2& centre,
                                    const PairRange& range);

// Returns place_at(range, s) or, if there is a clear part, the place in the clear part that is
// nearest to place_at(range, s). O(1).
double clear_place_at(const PairRange& range, const std::optional<PairRange>& clear, double s);

}  // namespace evenlift
