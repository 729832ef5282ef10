#include "candidates/candidate_seeds.h"

#include <utility>

#include "candidates/pair_range.h"
#include "evenlift/tolerance.h"

namespace evenlift {

CandidateSeeds::CandidateSeeds(const Polygon& polygon, const Vec2& centre, const RadialView& view,
                               const std::vector<OppositeVertices>& opposite, double min_ratio,
                               Positions positions, double clear, bool traced)
    : polygon_(polygon),
      centre_(centre),
      view_(view),
      min_ratio_(min_ratio),
      positions_(positions),
      clear_(clear),
      traced_(traced),
      corners_(polygon),
      has_opposite_(polygon.size()) {
  for (const OppositeVertices& two : opposite) has_opposite_[two.v] = has_opposite_[two.w] = true;
}

bool CandidateSeeds::ends_at_opposite_vertices(const EdgePair& pair) const {
  const auto at = [&](std::uint32_t vertex_a, std::uint32_t vertex_b) {
    return has_opposite_[vertex_a != inside_edge ? vertex_a : vertex_b];
  };
  return at(pair.begin_a, pair.begin_b) || at(pair.end_a, pair.end_b);
}

void CandidateSeeds::examine_and_add(const EdgePair& pair) {
  const SeenEdge a = see(polygon_, view_, pair.a), b = see(polygon_, view_, pair.b);
  const QuickVerdict quick = ends_at_opposite_vertices(pair)
                                 ? QuickVerdict::unsure
                                 : examine_quickly(polygon_, centre_, a, b, pair, min_ratio_);
  switch (quick) {
    case QuickVerdict::none:
      return;
    case QuickVerdict::at_begin:
      return add_vertex_chord(pair, pair.begin_a, pair.begin_b);
    case QuickVerdict::at_end:
      return add_vertex_chord(pair, pair.end_a, pair.end_b);
    case QuickVerdict::bisecting:
      offsets_.push_back(bisecting_offset(centre_, a, b));
      return add_seed(
          BisectingSeed{pair.a, pair.b, static_cast<std::uint32_t>(offsets_.size() - 1)},
          rightward(offsets_.back()));
    case QuickVerdict::unsure:
      break;
  }
  const PairVerdict verdict = examine(polygon_, centre_, a, b, pair, min_ratio_);
  if (verdict.candidate) add_finished(*verdict.candidate);
}

void CandidateSeeds::examine_and_add(const OppositeVertices& opposite) {
  const Candidate candidate = opposite_chord(polygon_, centre_, opposite);
  if (reaches(candidate.chord, min_ratio_)) add_finished(candidate);
}

void CandidateSeeds::add_range(const EdgePair& pair) {
  const SeenEdge a = see(polygon_, view_, pair.a), b = see(polygon_, view_, pair.b);
  const auto range = find_range(polygon_, centre_, a, b, pair, min_ratio_);
  if (!range || is_one_place(*range, near_distance(polygon_.diameter()))) return;
  const auto clear = clear_part({polygon_, corners_, clear_}, centre_, *range);
  for (const double s : range_places)
    add_finished(range_candidate(centre_, *range, clear_place_at(*range, clear, s)));
}

void CandidateSeeds::add_finished(const Candidate& candidate) {
  finished_.push_back(candidate);
  add_seed(FinishedSeed{static_cast<std::uint32_t>(finished_.size() - 1)}, candidate.direction);
}

void CandidateSeeds::add_vertex_chord(const EdgePair& pair, std::uint32_t vertex_a,
                                      std::uint32_t vertex_b) {
  const VertexChordSeed seed = vertex_a != inside_edge
                                   ? VertexChordSeed{pair.a, pair.b, vertex_a, vertex_b}
                                   : VertexChordSeed{pair.b, pair.a, vertex_b, inside_edge};
  add_seed(seed, rightward(centre_ - polygon_.vertex(seed.vertex)));
}

void CandidateSeeds::add_seed(const Seed& seed, const Vec2& direction) {
  keys_.push_back(slope_key(direction, static_cast<std::uint32_t>(seeds_.size())));
  seeds_.push_back(seed);
  if (traced_) source_of_seed_.push_back(sources_);
}

Candidate CandidateSeeds::grow(const VertexChordSeed& seed) const {
  return vertex_candidate(polygon_, centre_, seed.vertex, seed.edge,
                          see(polygon_, view_, seed.other), seed.opposite);
}

Candidate CandidateSeeds::grow(const BisectingSeed& seed) const {
  return bisecting_candidate(centre_, seed.edge_a, seed.edge_b, offsets_[seed.offset]);
}

Candidate CandidateSeeds::grow(const FinishedSeed& seed) const { return finished_[seed.index]; }

std::vector<Candidate> CandidateSeeds::grow() {
  sort_keys(keys_);
  std::vector<Candidate> candidates;
  candidates.reserve(keys_.size());
  for (const SlopeKey key : keys_) {
    const std::uint32_t seed = number_of(key);
    candidates.push_back(std::visit([&](const auto& each) { return grow(each); }, seeds_[seed]));
    if (traced_) candidates.back().source = source_of_seed_[seed];
  }
  settle_order(candidates, near_distance(polygon_.diameter()));
  return candidates;
}

}  // namespace evenlift
