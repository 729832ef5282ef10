// The lines on which robots with a size lift: edges moved inward by the depth of the hand, with
// their usable intervals; and the chords between them (docs/stands.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "candidates/pair_range.h"
#include "evenlift/candidates.h"
#include "evenlift/stands.h"

namespace evenlift {

// An edge moved inward, as C sees it. Its point at t is C + start + t along.
struct StandLine {
  std::uint32_t edge = 0;
  Vec2 start = Vec2::Zero(), along = Vec2::Zero();  // a point relative to C; a unit vector
  double low = 0, high = 0;                         // the first and last place to stand
  Stands::Stretches usable{nullptr, nullptr};
  // start x along: the distance from C, positive if the line runs counter-clockwise about C.
  double height = 0;
  Vec2 at(double t) const { return start + t * along; }
};

// The line of an edge; nothing if no robot can stand at the edge. O(1).
std::optional<StandLine> stand_line(const Polygon& polygon, const Vec2& centre,
                                    const Stands& stands, std::uint32_t edge);

// The chords about C between two lines, neither within tau L of C, whose load ratio is at least the
// minimum, within tolerance, and whose robots do not collide:
//   - first the chord with the best ratio; if all ratios are equal, the one nearest to the middle
//     of the lines' common range; of equally good ones the longest;
//   - the chords at which a usable interval ends on both lines, as between opposite vertices.
// O(s^2) for s usable intervals of both lines, plus O(log n) for each chord.
std::vector<Candidate> standing_chords(const Stands& stands, const Vec2& centre, const StandLine& a,
                                       const StandLine& b, double min_ratio, double near);

// The same chords for an edge pair of the polygon, for hands without depth. The pair's candidate
// stays unchanged if two robots can stand there.
std::vector<Candidate> standing_chords(const Polygon& polygon, const Stands& stands,
                                       const Vec2& centre, const EdgePair& pair, double min_ratio);

// The same as standing_ranges() of candidates.h, for two lines. Neither line may pass within tau L
// of C. O(usable intervals of a times those of b).
std::vector<PairRange> standing_ranges(const StandLine& a, const StandLine& b, double min_ratio,
                                       double near);

// The candidates that positions anywhere in the range add: two in the longest range of two lines of
// from.stands, far enough from corners where possible. Those with too low a load ratio or with
// colliding robots are dropped. Empty if the range is only one place. O(usable intervals of a times
// those of b).
std::vector<Candidate> standing_range_chords(const FromCorners& from, const Vec2& centre,
                                             const StandLine& a, const StandLine& b,
                                             double min_ratio, double near);

// Whether both robots of a candidate can stand at its ends and do not collide. O(log n).
bool can_stand(const Stands& stands, const Candidate& candidate);

}  // namespace evenlift
