// Candidates are made in two steps: first a short seed and a sort key for each, then candidates
// from the sorted seeds. So the large records of the candidates are written only once, and in
// order.
#pragma once

#include <cstdint>
#include <variant>
#include <vector>

#include "candidates/candidate_order.h"
#include "candidates/pair_candidate.h"
#include "chords/radial_view.h"
#include "evenlift/candidates.h"
#include "polygon/corners.h"

namespace evenlift {

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

}  // namespace evenlift
