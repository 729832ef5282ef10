// Candidate chords: at most one of each edge-pair, and those between opposite vertices, in order of
// slope and without duplicates (algorithm.md, Candidates; thesis 3.2, 3.3, 4.2). With positions
// anywhere in the range, an edge-pair offers two more (algorithm.md, Ranges).
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/chords.h"
#include "evenlift/document.h"

namespace evenlift {

// `range` is a chord at some other place of the range of its edge-pair.
enum class CandidateKind : std::uint8_t { bisecting, midpoint, vertex, range };

// "bisecting", "midpoint", "vertex" or "range". O(1).
std::string_view name(CandidateKind kind);

struct Candidate {
  Chord chord;
  CandidateKind kind = CandidateKind::bisecting;
  bool between_vertices = false;  // both ends are vertices
  std::uint32_t source = 0;       // of trace_candidates() only: see there
  Vec2 direction =
      Vec2::Zero();   // from r1 to r2, not normalized; the same for chords of one vertex
  double length = 0;  // |r1 r2|
};

// The chords of the candidates with these indices, in the order of the indices. O(their number).
std::vector<Chord> chords_of(const std::vector<Candidate>& candidates,
                             const std::vector<std::uint32_t>& indices);

// Whether a chord is even: its load ratio is at least 1 - tau. O(1).
bool is_even(const Chord& chord);

// The decision about one edge-pair: its candidate, if it has one, and the reason.
struct PairVerdict {
  double g0 = 0, g1 = 0;  // |C r_b| / |C r_a| at the beginning and the end of the range
  bool parallel = false;  // g0 and g1 agree within tolerance
  bool bisected = false;  // not parallel, and C bisects some chord of the pair
  std::optional<Candidate> candidate;
};

// Decides about one edge-pair. O(1).
PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio);

// The chord between two opposite vertices. It is a candidate if its load ratio is at least the
// minimum. O(1).
Candidate opposite_chord(const Polygon& polygon, const Vec2& centre,
                         const OppositeVertices& opposite);

// The chords of an edge-pair that are even enough. A place x in [0, 1] runs linearly along the
// section of edge a, from its beginning to its end: r_a - C = (1 - x) a0 + x a1, and
// |C r_a| / |C r_b| = (1 - x) q0 + x q1.
struct PairRange {
  std::uint32_t a = 0, b = 0;                 // the edges
  Vec2 a0 = Vec2::Zero(), a1 = Vec2::Zero();  // the ends of the section of a, from C
  double q0 = 1, q1 = 1;                      // > 0
  double first = 0, last = 1;                 // the places of the range, first <= last

  double q(double x) const { return (1 - x) * q0 + x * q1; }
};

// The range of an edge-pair: the places at which the load ratio is at least `min_ratio`, or the
// whole section if the edges are parallel and their ratio is at least the minimum, within
// tolerance. Nothing if there is no such place. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                                  double min_ratio);

// The same of a chord with one end on each of two edges, such as that of a candidate. Nothing also
// if the edges do not face each other. O(1).
std::optional<PairRange> range_of(const Polygon& polygon, const Vec2& centre, const Chord& chord,
                                  double min_ratio);

// The chord of a range at the place x in [0, 1]. O(1).
Chord chord_at(const Vec2& centre, const PairRange& range, double x);

// The place of the chord of a range whose direction is (1 - s) times that of the chord at `first`
// and s times that at `last`, both as long as the chords are. So the place does not depend on which
// of the two edges is called a. O(1).
double place_at(const PairRange& range, double s);

// The place of the range at which C sees the end on edge a in a direction, or the one nearest to
// it. O(1).
double place_towards(const PairRange& range, const Vec2& direction);

// The two range candidates of a pair are at place_at(range, s) for these s, or at the nearest place
// at which both robots are at least `clear` from the corners (Polygon::is_corner) of their edges,
// if the range has one. At the very ends of the range robots would often stand on corners, where
// their contacts do not count.
inline constexpr double range_places[] = {1.0 / 16, 15.0 / 16};

// All candidates in candidate order; `min_ratio` in [0, 1]. It is an error if there are more than
// max_edge_pairs edge-pairs and opposite vertices, or a third of that with positions anywhere in
// the range. For K of them O(n log n + K) if few candidates lie on one line through C, and O(n log
// n + K log K) at worst.
Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio,
                                               Positions positions = Positions::best,
                                               double clear = 0);

// Stands for "none" in arrays of indices, where an optional would double the memory.
inline constexpr std::uint32_t no_index = ~std::uint32_t{0};

// The same candidates, and their sources. The sources are numbered: first the edge-pairs in the
// order of edge_pairs(), then the opposite vertices in the order of opposite_vertices(). The
// `source` of a candidate is the one whose chord was kept when duplicates were merged.
struct TracedCandidates {
  std::vector<Candidate> candidates;
  std::vector<std::uint32_t> of_source;  // the candidate that each source led to, or no_index
  // What the two range candidates of each source became, in order of slope, or no_index; empty
  // with the best positions only.
  std::vector<std::array<std::uint32_t, 2>> ranges_of_source;
};
Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio, Positions positions = Positions::best,
                                          double clear = 0);

// The candidates of robots with a size: the chords on which a team's two robots can stand, and lift
// beneath the object. Of each two edges that face each other, moved inward by the hand's depth, the
// one with the best load ratio, and those at which both edges' stretches end (docs/stands.md); with
// positions anywhere in the range also one at each of range_places in the longest of the
// standing_ranges(). Each is wholly usable, its robots do not collide, and its ends are lifting
// points. Of several candidates of a source `of_source` is the best one. A source whose edges do
// not face each other on the outline itself is no_index. The cost is that of find_candidates(), and
// O(stretches of a times those of b) for each pair.
class Stands;
Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands,
                                             Positions positions = Positions::best,
                                             double clear = 0);

// What robots with a size leave of the range of two edges, or of these moved inward: the parts in
// which both robots can stand, each from its first place, 0, to its last, 1; in order along edge a.
// Their places are lifting points. Whether the two robots collide is not asked. O(stretches of a
// times those of b).
std::vector<PairRange> standing_ranges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                       std::uint32_t b, double min_ratio, const Stands& stands);

// The number of the longest of at least one ranges of two edges, by the ways on both edges; of
// those that agree within `near` the first. O(their number).
std::size_t longest_range(const std::vector<PairRange>& ranges, double near);

}  // namespace evenlift
