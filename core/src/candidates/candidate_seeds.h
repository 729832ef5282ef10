// Candidates in two steps, so that the large records are written once and in their order: first a
// short seed of each and the key of its slope, then, sorted by these, the candidates themselves.
#pragma once

#include <cstdint>
#include <vector>

#include "candidates/candidate_order.h"
#include "candidates/pair_candidate.h"
#include "chords/radial_view.h"
#include "evenlift/candidates.h"

namespace evenlift {

class CandidateSeeds {
 public:
  // With `traced`, grow() notes in each candidate its source: the number of the call of add() that
  // it came from.
  CandidateSeeds(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                 double min_ratio, bool traced)
      : polygon_(polygon), centre_(centre), view_(view), min_ratio_(min_ratio), traced_(traced) {}

  // Takes in an edge-pair or two opposite vertices: at most one seed. Amortized O(1).
  void add(const EdgePair& pair) {
    examine_and_add(pair);
    ++sources_;
  }
  void add(const OppositeVertices& opposite) {
    examine_and_add(opposite);
    ++sources_;
  }

  // The candidates of all sources in candidate order, duplicates not merged. It may be called only
  // once. O(m), and O(l log l) for each line with l of the m candidates.
  std::vector<Candidate> grow();

 private:
  // A vertex-chord from `vertex` of `edge` to `other`, at `opposite` of that if not inside_edge.
  // With a vertex of inside_edge a bisecting chord on both edges, its offset numbered `opposite`.
  // With an edge of inside_edge, the finished candidate `opposite`.
  struct Seed {
    std::uint32_t edge, other, vertex, opposite;
  };
  void examine_and_add(const EdgePair& pair);
  void examine_and_add(const OppositeVertices& opposite);
  SeenEdge see(std::uint32_t edge) const {
    return {edge, polygon_.vertex(view_.first(edge)), polygon_.vertex(view_.last(edge)),
            view_.area(edge)};
  }
  void add_seed(const Seed& seed, const Vec2& direction);
  void add_finished(const Candidate& candidate);
  void add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a, std::uint32_t vertex_b);
  Candidate grow(const Seed& seed) const;

  const Polygon& polygon_;
  const Vec2& centre_;
  const RadialView& view_;
  double min_ratio_;
  bool traced_;
  std::uint32_t sources_ = 0;
  std::vector<Seed> seeds_;
  std::vector<std::uint32_t> source_of_seed_;  // if traced
  std::vector<SlopeKey> keys_;
  std::vector<Vec2> offsets_;
  std::vector<Candidate> finished_;
};

}  // namespace evenlift
