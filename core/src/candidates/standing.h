// The lines on which robots with a size lift, and the chords between these lines (docs/stands.md).
// Each line is an edge moved inward by the depth of the hand, with the edge's usable intervals.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "candidates/pair_candidate.h"
#include "evenlift/candidates.h"
#include "evenlift/stands.h"

namespace evenlift {

// An edge moved inward, relative to C. The line's point at the parameter t is C + at(t).
struct StandLine {
  std::uint32_t edge = 0;
  Vec2 start, along;         // `along` is a unit vector
  double low = 0, high = 0;  // the first and the last usable t
  Stands::Stretches usable{nullptr, nullptr};
  // The distance of the line from C: cross(start, along), which is positive if the line runs
  // counter-clockwise about C.
  double height = 0;
  Vec2 at(double t) const { return start + t * along; }
};

// Returns the line of an edge, or nothing if no robot can stand at the edge. O(1).
std::optional<StandLine> stand_line(const Polygon& polygon, const Vec2& centre,
                                    const Stands& stands, std::uint32_t edge);

// Chords through C from line a to line b. Each meets the minimum ratio, within tolerance:
//   - first the chord with the best ratio or, if the ratios of all chords are equal, the chord
//     nearest to the middle of the lines' common range; of equally good chords, the longest;
//   - then the chords that join ends of usable intervals, as between opposite vertices.
// A chord whose two robots would collide is left out. There are no chords if a line passes within
// `near` (tau L) of C. O(s^2) for s usable intervals in all, plus O(log n) for each chord.
std::vector<Candidate> standing_chords(const Stands& stands, const Vec2& centre, const StandLine& a,
                                       const StandLine& b, double min_ratio, double near);

// The same chords for an edge pair of the polygon. The hands must have no depth. If two robots can
// stand at the ends of the pair's candidate, this candidate comes first, unchanged; for robots that
// are points, it is then the only chord.
std::vector<Candidate> standing_chords(const Polygon& polygon, const Stands& stands,
                                       const Vec2& centre, const EdgePair& pair, double min_ratio);

// The same as standing_ranges() of candidates.h, but for two lines. There are no ranges if a line
// passes within `near` (tau L) of C. O(usable intervals of `a` times those of `b`).
std::vector<PairRange> standing_ranges(const StandLine& a, const StandLine& b, double min_ratio,
                                       double near);

// The candidates that two lines of from.stands add with positions anywhere in the range: two in the
// longest range of the lines, at least `from.clear` away from corners where possible. A candidate
// is dropped if its load ratio is too low or if its robots would collide. There are no candidates
// if the range is only one place. O(usable intervals of `a` times those of `b`).
std::vector<Candidate> standing_range_chords(const FromCorners& from, const Vec2& centre,
                                             const StandLine& a, const StandLine& b,
                                             double min_ratio, double near);

// Whether both robots of a candidate can stand at its ends and do not collide. O(log n).
bool can_stand(const Stands& stands, const Candidate& candidate);

// --- The chords between two lines on which robots with a size lift, and the parts of the lines in
// which two robots can stand at the ends of a chord.

// The chords through C between two lines `a` and `b`, with the end r_a on `a` and r_b on `b`. The
// place t of r_a along `a` determines a chord; the ratio q = |C r_a| / |C r_b| is linear in t. The
// lines must outlive the ChordRange, and neither may pass through C.
class ChordRange {
 public:
  ChordRange(const StandLine& a, const StandLine& b) : a_(a), b_(b) {
    q0_ = -cross(a.start, b.along) / b.height;
    slope_ = -cross(a.along, b.along) / b.height;
  }

  double q(double t) const { return q0_ + t * slope_; }
  double slope() const { return slope_; }
  double q0() const { return q0_; }

  // The place of r_b along `b`, for the chord whose end r_a is at `t` along `a`. O(1).
  double on_b(double t) const { return dot(-a_.at(t) / q(t) - b_.start, b_.along); }

  // Returns the part of `of_a` whose chords end in `of_b`, whatever their load ratio; nothing if
  // there are no such chords. `of_a` is a piece of `a`, and `of_b` a piece of `b`. O(1).
  std::optional<Stretch> common(const Stretch& of_a, const Stretch& of_b) const;

  // The parts of `a` whose chords have at least the minimum load ratio, within tolerance, and two
  // ends where robots can stand. These parts are in the order of the usable intervals of `a`.
  // O(usable intervals of `a` times those of `b`).
  std::vector<Stretch> pieces(double min_ratio) const;

 private:
  std::optional<Stretch> with_ratio(Stretch stretch, double low, double high) const;
  std::optional<Stretch> that_reach(const Stretch& stretch, const Stretch& of_b) const;
  double on_a(double t_b) const;

  const StandLine &a_, &b_;
  double q0_ = 0, slope_ = 0;
};

// --- The pairs of lines that face each other across C. The lines need not form an outline.

// Calls visit(i, j) for each pair of lines that face each other: for an open range of directions u,
// the ray from C along u meets line i and the ray from C along -u meets line j. Lines that pass
// within `near` of C are in no pair. `visit` returns whether to continue. O(m log m + K) for m
// lines and K pairs.
void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit);

}  // namespace evenlift
