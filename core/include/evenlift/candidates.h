// Candidate chords in the order of their slopes, without duplicates. Each edge pair and each pair
// of opposite vertices gives at most one candidate (algorithm.md, Candidates; thesis 3.2, 3.3,
// 4.2). With positions anywhere in the range, an edge pair gives up to two more (algorithm.md,
// Ranges).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"
#include "evenlift/tolerance.h"

namespace evenlift {

// How the place of a candidate was found (algorithm.md, Candidates). A candidate of the kind
// `range` is at any other place in the range of its edge pair.
enum class CandidateKind : std::uint8_t { bisecting, midpoint, vertex, range };

// The name of a kind, such as "bisecting". O(1).
std::string_view name(CandidateKind kind);

struct Candidate {
  Chord chord;
  CandidateKind kind = CandidateKind::bisecting;
  bool between_vertices = false;
  std::uint32_t source = 0;  // see TracedCandidates
  // A vector of any length from r1 towards r2. Chords that lead from one vertex to the interiors of
  // edges have exactly the same vector.
  Vec2 direction;
  double length = 0;  // |r1 r2|
};

// The chords of the candidates with these indices, in the order of the indices. O(indices).
std::vector<Chord> chords_of(const std::vector<Candidate>& candidates,
                             const std::vector<std::uint32_t>& indices);

// Whether the load ratio of a chord is at least `even_ratio`. O(1).
bool is_even(const Chord& chord);
inline constexpr double even_ratio = 1.0 - tau;

// The candidate of an edge pair, and the values on which it depends. A chord of the pair ends at
// r_a on edge a and at r_b on edge b.
struct PairVerdict {
  double g0 = 0, g1 = 0;  // |C r_b| / |C r_a| at the pair's beginning and end
  bool parallel = false;  // g0 and g1 agree within tolerance
  bool bisected = false;  // not parallel, and C bisects a chord of the pair
  std::optional<Candidate> candidate;
};

// Finds the candidate of an edge pair, if it has one. O(1).
PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio);

// The chord between two opposite vertices. It is a candidate if its load ratio is at least the
// minimum. O(1).
Candidate opposite_chord(const Polygon& polygon, const Vec2& centre,
                         const OppositeVertices& opposite);

// The chords of an edge pair that meet the minimum ratio. Each chord has a place x in [0, 1], which
// runs linearly along the section of edge a: r_a - C = (1 - x) a0 + x a1, and |C r_a| / |C r_b| =
// (1 - x) q0 + x q1.
struct PairRange {
  std::uint32_t a = 0, b = 0;  // the edges
  Vec2 a0, a1;                 // ends of edge a's section, relative to C
  double q0 = 1, q1 = 1;       // q(0) and q(1), > 0
  double first = 0, last = 1;  // the range's ends, first <= last

  double q(double x) const { return (1 - x) * q0 + x * q1; }
};

// The range of an edge pair: the places where the load ratio is at least `min_ratio`; nothing if
// there are no such places. The range is the whole section if the edges are parallel and the ratio
// of their chords is at least the minimum, within tolerance. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                                  double min_ratio);

// The range of the two edges on which a chord ends; nothing if no place there meets the minimum
// ratio, or if the edges do not face each other. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const Chord& chord,
                                  double min_ratio);

// The chord at place x in [0, 1]. O(1).
Chord chord_at(const Vec2& centre, const PairRange& range, double x);

// The place whose chord has the direction (1 - s) d0 + s d1, where d0 and d1 are the vectors from
// end to end of the chords at `first` and `last`. The chord there is the same whichever of the two
// edges is `a`. O(1).
double place_at(const PairRange& range, double s);

// The place of the chord whose end on edge a is in this direction from C. If the range has no such
// place, the result is the nearest place in the range. O(1).
double place_towards(const PairRange& range, const Vec2& direction);

// A pair's range candidates are at place_at(range, s) for these s. If robots there would be nearer
// than `clear` to a corner (Polygon::is_corner) of their edges, the candidate moves to the nearest
// place in the range, if any, where both are at least `clear` from corners. The ends of the range
// are not used, since robots there would often stand on corners, where contacts do not count.
inline constexpr double range_places[] = {1.0 / 16, 15.0 / 16};

// Returns all candidates in order. `min_ratio` is in [0, 1]; see range_places for `clear`. Let K be
// the number of edge pairs and pairs of opposite vertices together. It is an error if K exceeds
// max_edge_pairs or, with positions anywhere in the range, a third of it. O(n log n + K) if few
// candidates lie on one line through C, O(n log n + K log K) at worst.
Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio,
                                               Positions positions = Positions::best,
                                               double clear = 0);

// The index that means "none" in arrays; a std::optional would double the memory.
inline constexpr std::uint32_t no_index = ~std::uint32_t{0};

// The candidates with their sources. A source is an edge pair or a pair of opposite vertices.
// Sources are numbered: first the edge_pairs(), then the opposite_vertices(), in order. If
// duplicates were merged, `source` is the source of the chord that was kept.
struct TracedCandidates {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> of_source;  // the candidate of each source, or no_index
  // The two range candidates of each source, in order of slope; no_index if there are fewer. The
  // list is empty with Positions::best.
  std::vector<std::array<std::uint32_t, 2>> ranges_of_source;
};
Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio, Positions positions = Positions::best,
                                          double clear = 0);

// The candidates of robots with a size: chords whose ends are usable lifting points of two robots
// that do not collide (docs/stands.md). Two facing edges, moved inward by the hand's depth, give
// first the chord with the best load ratio, then each chord that joins ends of two usable
// intervals. If the hand has no depth and robots can stand at the edge pair's own candidate, this
// candidate replaces the first of these chords or, for robots that are points, all of them.
// Opposite vertices give a candidate only to robots that are points. With positions anywhere in the
// range, the two edges also give one chord at each of range_places in the longest of the
// standing_ranges(). `of_source` has the best candidate of each source. A candidate's `source` is
// no_index if its edges do not face each other before they are moved. Costs as much as
// find_candidates(), plus O(s t) for each pair of edges with s and t usable intervals.
class Stands;
Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands,
                                             Positions positions = Positions::best,
                                             double clear = 0);

// The parts of the range of two edges in which two robots with a size can stand, in order along
// edge a. The edges are moved inward by the hand's depth, so the ends of a part's chords are
// lifting points. The places of each part run from 0 to 1. The two robots may still collide there.
// O(s t) if the edges have s and t usable intervals.
std::vector<PairRange> standing_ranges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                       std::uint32_t b, double min_ratio, const Stands& stands);

// The index of the longest of one or more ranges, measured along both edges. If the lengths of
// several agree within `near`, it is the first of them. O(ranges).
std::size_t longest_range(const std::vector<PairRange>& ranges, double near);

}  // namespace evenlift
