// The range of an edge pair (algorithm.md, Ranges): where chords meet the minimum ratio, and the
// two candidates that it adds.
#pragma once

#include <optional>

#include "candidates/pair_candidate.h"
#include "evenlift/stands.h"
#include "polygon/corners.h"

namespace evenlift {

// See range_of() (candidates.h). O(1).
std::optional<PairRange> find_range(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                                    const SeenEdge& b, const EdgePair& pair, double min_ratio);

// Whether all chords of the range agree within `near`, so that it adds no candidates. O(1).
bool is_one_place(const PairRange& range, double near);

// The candidate at a place x. O(1).
Candidate range_candidate(const Vec2& centre, const PairRange& range, double x);

// The distance that range candidates keep from corners.
struct FromCorners {
  const Polygon& polygon;
  const Corners& corners;
  double clear = 0;
  const Stands* stands = nullptr;  // of robots with a size: then the contacts keep the distance
};

// The part of the range where both robots are at least `clear` from the corners of their edges,
// within tau L. Nothing for at most one place, or if `clear` is 0. O(1).
std::optional<PairRange> clear_part(const FromCorners& from, const Vec2& centre,
                                    const PairRange& range);

// place_at(range, s), or the nearest place in the clear part, if there is one. O(1).
double clear_place_at(const PairRange& range, const std::optional<PairRange>& clear, double s);

}  // namespace evenlift
