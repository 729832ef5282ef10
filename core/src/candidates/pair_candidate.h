// The candidates of edge pairs: facing edges, the cases, ranges, and even chords about many centres.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "chords/radial_view.h"
#include "evenlift/candidates.h"
#include "evenlift/chords.h"
#include "evenlift/polygon.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "polygon/corners.h"

namespace evenlift {

// --- Whether two edges face each other across C, without a sweep over all edges.

// The edge pair in which rays from C meet edge `a` and the opposite rays meet edge `b`. Returns
// nothing if the edges do not face each other (an exact test, as in edge_pairs()), or if the line
// of one passes within `near` of C, so that this edge is radial. O(1).
std::optional<EdgePair> pair_of_edges(const Polygon& polygon, const Vec2& centre, std::uint32_t a,
                                      std::uint32_t b, double near);

// --- The candidate of one edge pair (algorithm.md, Candidates): the cases and their arithmetic.

// A non-radial edge, with its two ends in counter-clockwise order as C sees them.
struct SeenEdge {
  std::uint32_t edge;
  const Vec2& first;
  const Vec2& last;
  double doubled_area;  // orient(centre, first, last) > 0
};

// Returns an edge as C sees it. The polygon must outlive the result. O(1).
SeenEdge see(const Polygon& polygon, const Vec2& centre, std::uint32_t edge);
inline SeenEdge see(const Polygon& polygon, const RadialView& view, std::uint32_t edge) {
  return {edge, polygon.vertex(view.first(edge)), polygon.vertex(view.last(edge)),
          view.doubled_area(edge)};
}

// One end of a pair's range, with the vertex-chord there.
struct SectionEnd {
  std::uint32_t vertex;    // the vertex at which the range ends
  std::uint32_t opposite;  // the vertex across C if the chord ends at one, otherwise inside_edge
  bool on_a;               // whether the vertex is an end of edge a
  Across across;           // the other end of the vertex-chord, on the other edge
  double g;                // |C r_b| / |C r_a|
  int compare_to_one;      // -1, 0, 1: g is below, equal to or above 1; exact
};

// One end of the range: there, the section of edge `a` ends at `vertex_a`, and the section of edge
// `b` ends at `vertex_b`. One of these vertices may be inside_edge (chords.h). O(1).
SectionEnd section_end(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                       const SeenEdge& b, std::uint32_t vertex_a, std::uint32_t vertex_b);

// The vector r_a - C at a section end. O(1).
Vec2 offset_on_a(const Polygon& polygon, const Vec2& centre, const SectionEnd& end);

// Whether two edges count as parallel; g0 and g1 are g at the ends of their range. O(1).
inline bool are_parallel(double g0, double g1) {
  return std::fabs(g0 - g1) <= tau * std::max(g0, g1);
}

// Decides whether the edge pair has a candidate, and finds the candidate. O(1).
PairVerdict examine(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                    const SeenEdge& b, const EdgePair& pair, double min_ratio);

// Returns the decision of examine() if estimates make it certain, otherwise `unsure`. Estimates
// suffice for most pairs, which have no candidate or one of two frequent kinds. Neither end of the
// pair's range may be at a vertex that has an opposite vertex. O(1).
enum class QuickVerdict : std::uint8_t { unsure, none, bisecting, at_begin, at_end };
QuickVerdict examine_quickly(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                             const SeenEdge& b, const EdgePair& pair, double min_ratio);

// The vector r_a - C for the chord that C bisects. O(1).
Vec2 bisecting_offset(const Vec2& centre, const SeenEdge& a, const SeenEdge& b);

// The candidate on the chord that C bisects. `offset` must come from bisecting_offset(). O(1).
Candidate bisecting_candidate(const Vec2& centre, std::uint32_t edge_a, std::uint32_t edge_b,
                              const Vec2& offset);

// The candidate on the chord from `vertex`, an end of `edge`, through C to the edge `other`. Unless
// `opposite` is inside_edge, the chord ends at the vertex `opposite` of `other`. O(1).
Candidate vertex_candidate(const Polygon& polygon, const Vec2& centre, std::uint32_t vertex,
                           std::uint32_t edge, const SeenEdge& other, std::uint32_t opposite);

// The vertex-chord at one end of a pair's range, and its ends on a and b. The vertices are those of
// section_end(). O(1).
struct SectionRim {
  Chord chord;
  Vec2 on_a, on_b;
};
SectionRim section_rim(const Polygon& polygon, const Vec2& centre, const SeenEdge& a,
                       const SeenEdge& b, std::uint32_t vertex_a, std::uint32_t vertex_b);

// Whether the load ratio of the chord is at least the minimum, within tolerance. O(1).
bool reaches(const Chord& chord, double min_ratio);

// The direction or its opposite: the one that points from a chord's end r1 to its end r2. O(1).
Vec2 rightward(const Vec2& direction);

// --- The range of an edge pair (algorithm.md, Ranges), in which chords meet the minimum ratio, and the
// two candidates that the range adds.

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

// --- Even candidates about many centres, one after another. The ends of an even chord about a centre M
// are where the outline meets its mirror image in M. A tree of boxes finds these places without
// visiting every edge; the usual rules then decide which of the places give candidates.

class EvenChords {
 public:
  // The polygon and the stands must outlive the EvenChords. With stands, the candidates are those
  // of standing_candidates(). O(n).
  explicit EvenChords(const Polygon& polygon, const Stands* stands = nullptr);

  // Also prepares for some_about(). `walk` contains all edges in order along the outline, beginning
  // at a vertex that does not depend on the order of the vertex list. O(n).
  EvenChords(const Polygon& polygon, const Stands* stands, const std::vector<std::uint32_t>& walk);

  // Returns all even candidates about a centre, which may be anywhere. They are those of
  // find_candidates(polygon, centre, 1), but without a limit on their number. An end of a chord
  // between two vertices may name the other of the two edges at its vertex. If the outline hardly
  // winds: O(log n) for each place where it meets its mirror image, O(n) in all at worst.
  std::vector<Candidate> about(const Vec2& centre) const;

  // Returns even candidates about the centre: those between the edges of one sample, or all of them
  // if no sample has enough_chords candidates. If the outline has more than 1,000 edges, there are
  // samples with a half, a quarter, an eighth and so on of the edges, and the smallest one with
  // enough candidates, duplicates included, is used. Only an edge's number in the walk decides
  // which samples contain the edge. A strongly winding outline may have a hundred thousand even
  // chords about one centre, but a search needs only some of them. O(log n) for each place where
  // the sample meets its mirror image. Adds the work to `compared`, about the
  // number of boxes and edges compared.
  static constexpr std::size_t enough_chords = 32;
  std::vector<Candidate> some_about(const Vec2& centre, std::uint64_t& compared) const;

  // Returns the number of even candidates, duplicates included, but at most `most`. On a strongly
  // winding outline the count soon reaches `most`, so this function is fast where about() is slow.
  std::size_t count_about(const Vec2& centre, std::size_t most) const;

 private:
  class Search;

  // Some edges, in the order of their numbers.
  struct Sample {
    std::vector<std::uint32_t> edges;
    std::vector<LineEnds> lines;  // the edges, moved inward by the depth of the hand, if any
    EdgeTree tree;
  };
  static Sample sample_of(const Polygon& polygon, const Stands* stands,
                          const std::vector<std::uint32_t>& edges);
  std::vector<Candidate> about(const Vec2& centre, std::uint64_t& compared) const;
  std::vector<Candidate> in_order(const std::vector<Candidate>& found) const;

  const Polygon& polygon_;
  const Stands* stands_;
  Sample all_;
  std::vector<Sample> samples_;  // the smallest first
  double size_ = 0;              // the largest absolute value of a coordinate
};

}  // namespace evenlift
