#include "candidate_seeds.h"

#include <utility>

namespace evenlift {

void CandidateSeeds::examine_and_add(const EdgePair& pair) {
  const SeenEdge a = see(pair.a), b = see(pair.b);
  switch (examine_quickly(polygon_, centre_, a, b, pair, min_ratio_)) {
    case QuickVerdict::none:
      return;
    case QuickVerdict::at_begin:
      return add_vertex_chord(pair, pair.begin_a, pair.begin_b);
    case QuickVerdict::at_end:
      return add_vertex_chord(pair, pair.end_a, pair.end_b);
    case QuickVerdict::bisecting:
      offsets_.push_back(bisecting_offset(centre_, a, b));
      return add_seed(
          {pair.a, pair.b, inside_edge, static_cast<std::uint32_t>(offsets_.size() - 1)},
          rightward(offsets_.back()));
    case QuickVerdict::unsure:
      break;
  }
  const PairVerdict verdict = examine(polygon_, centre_, a, b, pair, min_ratio_);
  if (!verdict.candidate) return;
  finished_.push_back(*verdict.candidate);
  add_seed(
      {inside_edge, inside_edge, inside_edge, static_cast<std::uint32_t>(finished_.size() - 1)},
      verdict.candidate->direction);
}

void CandidateSeeds::add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a,
                                      std::uint32_t vertex_b) {
  const Seed seed = vertex_a != inside_edge ? Seed{pair.a, pair.b, vertex_a, vertex_b}
                                            : Seed{pair.b, pair.a, vertex_b, inside_edge};
  add_seed(seed, rightward(centre_ - polygon_.vertex(seed.vertex)));
}

void CandidateSeeds::add_seed(const Seed& seed, const Vec2& direction) {
  keys_.push_back(slope_key(direction, static_cast<std::uint32_t>(seeds_.size())));
  seeds_.push_back(seed);
}

Candidate CandidateSeeds::grow(const Seed& seed) const {
  if (seed.edge == inside_edge) return finished_[seed.opposite];
  if (seed.vertex == inside_edge)
    return bisecting_candidate(centre_, seed.edge, seed.other, offsets_[seed.opposite]);
  return vertex_candidate(polygon_, centre_, seed.vertex, seed.edge, see(seed.other),
                          seed.opposite);
}

void CandidateSeeds::note_pairs(std::vector<Candidate>& candidates) const {
  std::vector<std::uint32_t> pair_of_seed(seeds_.size());
  for (std::uint32_t pair = 0; pair < of_pairs_->size(); ++pair) {
    const std::uint32_t seed = (*of_pairs_)[pair];
    if (seed != no_candidate) pair_of_seed[seed] = pair;
  }
  for (std::size_t i = 0; i < candidates.size(); ++i)
    candidates[i].pair = pair_of_seed[number_of(keys_[i])];
}

std::vector<Candidate> CandidateSeeds::grow() {
  sort_keys(keys_);
  std::vector<Candidate> candidates;
  candidates.reserve(keys_.size());
  for (const SlopeKey key : keys_) candidates.push_back(grow(seeds_[number_of(key)]));
  if (of_pairs_) note_pairs(candidates);
  settle_order(candidates);
  return candidates;
}

}  // namespace evenlift
