// Candidate chords: at most one for each edge pair, and those between opposite vertices, ordered by
// slope and without duplicates (algorithm.md, Candidates; thesis 3.2, 3.3, 4.2). With positions
// anywhere in the range, an edge pair has two more (algorithm.md, Ranges).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift {

// `range` is a chord at another place in the range of its edge pair.
enum class CandidateKind : std::uint8_t { bisecting, midpoint, vertex, range };

// "bisecting", "midpoint", "vertex" or "range". O(1).
std::string_view name(CandidateKind kind);

struct Candidate {
  Chord chord;
  CandidateKind kind = CandidateKind::bisecting;
  bool between_vertices = false;  // both ends are vertices
  std::uint32_t source = 0;       // set by the functions that return TracedCandidates: see there
  Vec2 direction =
      Vec2::Zero();   // from r1 to r2, not normalized; exactly the same for chords from one vertex
  double length = 0;  // |r1 r2|
};

// The chords of the candidates with these indices, in the order of the indices. O(their number).
std::vector<Chord> chords_of(const std::vector<Candidate>& candidates,
                             const std::vector<std::uint32_t>& indices);

// Whether a chord is even: its load ratio is at least 1 - tau. O(1).
bool is_even(const Chord& chord);

// The candidate of an edge pair, if there is one, and what decided it.
struct PairVerdict {
  double g0 = 0, g1 = 0;  // |C r_b| / |C r_a| at the beginning and the end of the range
  bool parallel = false;  // g0 and g1 agree within tolerance
  bool bisected = false;  // not parallel, and C bisects some chord of the pair
  std::optional<Candidate> candidate;
};

// The verdict on one edge pair. O(1).
PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio);

// The chord between two opposite vertices. It is a candidate if its load ratio is at least the
// minimum. O(1).
Candidate opposite_chord(const Polygon& polygon, const Vec2& centre,
                         const OppositeVertices& opposite);

// The chords of an edge pair that meet the minimum ratio. A place x in [0, 1] runs linearly along
// the section of edge a, from its beginning to its end: r_a - C = (1 - x) a0 + x a1, and
// |C r_a| / |C r_b| = (1 - x) q0 + x q1.
struct PairRange {
  std::uint32_t a = 0, b = 0;                 // the edges
  Vec2 a0 = Vec2::Zero(), a1 = Vec2::Zero();  // ends of the section of a, relative to C
  double q0 = 1, q1 = 1;                      // > 0
  double first = 0, last = 1;                 // the limits of the range, first <= last

  double q(double x) const { return (1 - x) * q0 + x * q1; }
};

// The range of an edge pair: the places at which the load ratio is at least `min_ratio`. If the
// edges are parallel and their ratio is at least the minimum, within tolerance, the range is the
// whole section. Nothing if there is no such place. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                                  double min_ratio);

// The range of the two edges on which a chord ends, for example a candidate's chord. Also nothing
// if the edges do not face each other. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const Chord& chord,
                                  double min_ratio);

// The chord of a range at place x in [0, 1]. O(1).
Chord chord_at(const Vec2& centre, const PairRange& range, double x);

// The place in a range whose chord has the direction (1 - s) d0 + s d1, where d0 and d1 are the
// vectors from end to end of the chords at `first` and `last`. So the place does not depend on
// which of the two edges is called a. O(1).
double place_at(const PairRange& range, double s);

// The place in the range at which C sees the end on edge a in the given direction, or the nearest
// place to it. O(1).
double place_towards(const PairRange& range, const Vec2& direction);

// The two range candidates of a pair are at place_at(range, s) for these s, or at the nearest place
// where both robots are at least `clear` from the corners (Polygon::is_corner) of their edges, if
// the range has one. At the very ends of the range, robots would often stand on corners, where
// their contacts do not count.
inline constexpr double range_places[] = {1.0 / 16, 15.0 / 16};

// Returns all candidates in candidate order; `min_ratio` is in [0, 1]. It is an error if the number
// of edge pairs and opposite vertices exceeds max_edge_pairs, or a third of that with positions
// anywhere in the range. For K of them O(n log n + K) if few candidates lie on one line through C,
// and O(n log n + K log K) at worst.
Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio,
                                               Positions positions = Positions::best,
                                               double clear = 0);

// Means "none" in arrays of indices, where an optional would double the memory.
inline constexpr std::uint32_t no_index = ~std::uint32_t{0};

// The candidates with their sources. The sources are numbered: first the edge pairs in the order of
// edge_pairs(), then the opposite vertices in the order of opposite_vertices(). When duplicates are
// merged, the `source` of the candidate is the one whose chord was kept.
struct TracedCandidates {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> of_source;  // the candidate of each source, or no_index
  // The two range candidates of each source, in order of slope, or no_index; empty with
  // Positions::best.
  std::vector<std::array<std::uint32_t, 2>> ranges_of_source;
};
Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio, Positions positions = Positions::best,
                                          double clear = 0);

// The candidates of robots with a size: the chords at whose ends a team's two robots can stand
// outside the object and lift beneath it. Two facing edges, moved inward by the hand's depth, give
// the chord with the best load ratio, and each chord from an end of a usable interval to an end of
// another (docs/stands.md). With positions anywhere in the range there is also one at each of
// range_places in the longest of the standing_ranges(). The two robots of a chord do not collide,
// and its ends are usable lifting points. If a source has several candidates, `of_source` is the
// best; it is no_index if the edges do not face each other on the outline itself. The cost is that
// of find_candidates(), plus O(usable intervals of a times those of b) for each pair.
class Stands;
Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands,
                                             Positions positions = Positions::best,
                                             double clear = 0);

// The parts of the range of two edges, moved inward by the hand's depth, in which two robots with a
// size can stand, in order along edge a. Each part runs from its first place, 0, to its last, 1.
// The ends of their chords are lifting points. Collisions between the two robots are not checked.
// O(usable intervals of a times those of b).
std::vector<PairRange> standing_ranges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                       std::uint32_t b, double min_ratio, const Stands& stands);

// The index of the longest of one or more ranges of two edges, measured along both edges; of ranges
// that agree within `near`, the first. O(their number).
std::size_t longest_range(const std::vector<PairRange>& ranges, double near);

}  // namespace evenlift
