// Candidate order (algorithm.md, Candidates). A radix sort of 64-bit keys replaces most comparisons
// of candidates, so this stage is O(K), plus O(l log l) for each line with l candidates.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "candidates/pair_candidate.h"
#include "chords/radial_view.h"
#include "evenlift/candidates.h"
#include "polygon/corners.h"

namespace evenlift {

// The sort key of a candidate: 8 bytes to move instead of 104. The upper bits of the key hold the
// rounded slope, so keys are in the order of slopes, but different slopes may share a value.
// The lower bits hold the candidate's number, below max_edge_pairs, to order equal values.
using SlopeKey = std::uint64_t;

// The key of a candidate's direction and number. `direction` must point right or count as vertical,
// as in a Candidate. O(1).
SlopeKey slope_key(const Vec2& direction, std::uint32_t number);

// The candidate's number in a key. O(1).
std::uint32_t number_of(SlopeKey key);

// Sorts m keys by an LSD radix sort or, if there are few, by comparisons. On entry, the numbers in
// the keys must be in ascending order. O(m).
void sort_keys(std::vector<SlopeKey>& keys);

// Puts candidates that are sorted by key into candidate order, which is by exact slope. On one line
// the longest candidate comes first; of equally long ones, the one whose right end is farthest from
// C. If these distances also tie, the coordinates of the left end decide, then those of the right
// end, if they differ by more than `near` / 2. So the order of the vertex list never matters, and
// rounding hardly ever does. `near` is tau L. O(m), plus O(l log l) for each line with l
// candidates.
void settle_order(std::vector<Candidate>& candidates, double near);

// Returns the candidates, fewer than max_edge_pairs, in candidate order. Costs as much as
// settle_order().
std::vector<Candidate> in_candidate_order(const std::vector<Candidate>& found, double near);

// --- Candidates are made in two steps: first a short seed and a sort key for each, then candidates
// from the sorted seeds. So the large records of the candidates are written only once, and in
// order.

class CandidateSeeds {
 public:
  // If `traced` is true, grow() sets the source of each candidate, which is the number of the call
  // of add() that added its seed. Where possible, range candidates are at least `clear` from
  // corners. The polygon, C and the view must outlive the CandidateSeeds. O(n).
  CandidateSeeds(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                 const std::vector<OppositeVertices>& opposite, double min_ratio,
                 Positions positions, double clear, bool traced);

  // Each call adds at most one seed or, for an edge pair with positions anywhere in the range, at
  // most three. Amortized O(1).
  void add(const EdgePair& pair) {
    const std::size_t before = seeds_.size();
    examine_and_add(pair);
    // A pair without a candidate has no range.
    if (positions_ == Positions::range && seeds_.size() > before) add_range(pair);
    ++sources_;
  }
  void add(const OppositeVertices& opposite) {
    examine_and_add(opposite);
    ++sources_;
  }

  // Returns all m candidates, in candidate order and with duplicates. Call it only once. O(m), plus
  // O(l log l) for each line with l of the candidates.
  std::vector<Candidate> grow();

 private:
  // The arguments of vertex_candidate() (pair_candidate.h).
  struct VertexChordSeed {
    std::uint32_t edge, other, vertex, opposite;
  };
  // A chord that C bisects; `offset` is an index into offsets_.
  struct BisectingSeed {
    std::uint32_t edge_a, edge_b, offset;
  };
  // A candidate that is already made; `index` is an index into finished_.
  struct FinishedSeed {
    std::uint32_t index;
  };
  using Seed = std::variant<VertexChordSeed, BisectingSeed, FinishedSeed>;

  bool ends_at_opposite_vertices(const EdgePair& pair) const;
  void examine_and_add(const EdgePair& pair);
  void examine_and_add(const OppositeVertices& opposite);
  void add_range(const EdgePair& pair);
  void add_seed(const Seed& seed, const Vec2& direction);
  void add_finished(const Candidate& candidate);
  void add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a, std::uint32_t vertex_b);
  Candidate grow(const VertexChordSeed& seed) const;
  Candidate grow(const BisectingSeed& seed) const;
  Candidate grow(const FinishedSeed& seed) const;

  const Polygon& polygon_;
  const Vec2& centre_;
  const RadialView& view_;
  double min_ratio_;
  Positions positions_;
  double clear_;
  bool traced_;
  Corners corners_;
  std::vector<bool> has_opposite_;  // by vertex: whether it has an opposite vertex
  std::uint32_t sources_ = 0;
  std::vector<Seed> seeds_;
  std::vector<std::uint32_t> source_of_seed_;  // empty unless traced_
  std::vector<SlopeKey> keys_;
  std::vector<Vec2> offsets_;
  std::vector<Candidate> finished_;
};

// --- The merging of duplicate candidates (algorithm.md, Candidates).

struct MergedCandidates {
  std::vector<Candidate> candidates;  // in candidate order, without duplicates
  std::vector<std::uint32_t> became;  // for each given candidate, the index of the kept one
};

// Merges candidates whose ends both agree within `near`; the candidates must be in candidate order.
// Chords that agree directly, or through a chain of other chords, form one class. A class keeps its
// chord between two vertices or, if it has no such chord, the chord with the largest ratio; of
// several, the first. A kept chord between two vertices keeps its kind. Any other kept chord gets
// the first of the kinds bisecting, midpoint, vertex and range that occurs in its class. O(m) for m
// candidates, plus O(l log l) for each group of l candidates whose slopes could agree. The cost is
// greater if many different chords lie within `near` of each other.
MergedCandidates merge_duplicates(std::vector<Candidate> candidates, double near);

}  // namespace evenlift
