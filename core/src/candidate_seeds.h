// Candidates in two steps, so that the large records are written once and in their order: first a
// short seed of each and the key of its slope, then, sorted by these, the candidates themselves.
#pragma once

#include <cstdint>
#include <vector>

#include "candidate_order.h"
#include "evenlift/candidates.h"
#include "pair_candidate.h"
#include "radial_view.h"

namespace evenlift {

class CandidateSeeds {
 public:
  // With `of_pairs`, notes there for each pair, in the order of add(), its seed's number or
  // no_candidate, and grow() notes in each candidate its pair.
  CandidateSeeds(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                 double min_ratio, std::vector<std::uint32_t>* of_pairs = nullptr)
      : polygon_(polygon),
        centre_(centre),
        view_(view),
        min_ratio_(min_ratio),
        of_pairs_(of_pairs) {}

  // Takes in an edge-pair: at most one seed. Amortized O(1).
  void add(const EdgePair& pair) {
    const std::size_t before = seeds_.size();
    examine_and_add(pair);
    if (of_pairs_)
      of_pairs_->push_back(seeds_.size() > before ? static_cast<std::uint32_t>(before)
                                                  : no_candidate);
  }

  // The candidates of all pairs in candidate order, duplicates not merged. Once. O(m) and O(l log
  // l) for each line with l of them.
  std::vector<Candidate> grow();

 private:
  // A vertex-chord from `vertex` of `edge` to `other`, at `opposite` of that if not inside_edge.
  // With a vertex of inside_edge a bisecting chord on both edges, its offset numbered `opposite`.
  // With an edge of inside_edge, the finished candidate `opposite`.
  struct Seed {
    std::uint32_t edge, other, vertex, opposite;
  };
  void examine_and_add(const EdgePair& pair);
  SeenEdge see(std::uint32_t edge) const {
    return {edge, polygon_.vertex(view_.first(edge)), polygon_.vertex(view_.last(edge)),
            view_.area(edge)};
  }
  void add_seed(const Seed& seed, const Vec2& direction);
  void add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a, std::uint32_t vertex_b);
  Candidate grow(const Seed& seed) const;
  void note_pairs(std::vector<Candidate>& candidates) const;

  const Polygon& polygon_;
  const Vec2& centre_;
  const RadialView& view_;
  double min_ratio_;
  std::vector<std::uint32_t>* of_pairs_;
  std::vector<Seed> seeds_;
  std::vector<SlopeKey> keys_;
  std::vector<Vec2> offsets_;
  std::vector<Candidate> finished_;
};

}  // namespace evenlift
