#include "evenlift/candidates.h"

#include "candidates/candidate_seeds.h"
#include "candidates/duplicates.h"
#include "candidates/pair_candidate.h"
#include "chords/opposite_vertices.h"
#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

SeenEdge see(const Polygon& polygon, const Vec2& centre, std::uint32_t edge) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  const double area = orient(centre, p, q);
  if (area > 0) return {edge, p, q, area};
  return {edge, q, p, -area};
}

struct Found {
  std::vector<Candidate> candidates;
  std::uint32_t sources = 0;
  std::vector<std::uint32_t> source_of_chord;  // if traced: of each chord before merging ...
  std::vector<std::uint32_t> became;           // ... and the candidate that it led to
};

Result<Found> find(const Polygon& polygon, const Vec2& centre, double min_ratio, bool traced) {
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge-pairs")) return *error;
  const auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();

  CandidateSeeds seeds(polygon, centre, view, min_ratio, traced);
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) { seeds.add(pair); });
  for (const OppositeVertices& two : *opposite) seeds.add(two);
  Found found;
  found.candidates = seeds.grow();
  found.sources = static_cast<std::uint32_t>(pairs + opposite->size());
  if (traced)
    for (const Candidate& c : found.candidates) found.source_of_chord.push_back(c.source);
  found.became = merge_duplicates(found.candidates, near_distance(polygon.diagonal()));
  return found;
}

}  // namespace

std::string_view name(CandidateKind kind) {
  switch (kind) {
    case CandidateKind::bisecting:
      return "bisecting";
    case CandidateKind::midpoint:
      return "midpoint";
    case CandidateKind::vertex:
      return "vertex";
  }
  return {};
}

bool is_even(const Chord& chord) { return chord.ratio >= 1.0 - tau; }

PairVerdict examine_pair(const Polygon& polygon, const Vec2& centre, const EdgePair& pair,
                         double min_ratio) {
  return examine(polygon, centre, see(polygon, centre, pair.a), see(polygon, centre, pair.b), pair,
                 min_ratio);
}

Result<std::vector<Candidate>> find_candidates(const Polygon& polygon, const Vec2& centre,
                                               double min_ratio) {
  auto found = find(polygon, centre, min_ratio, false);
  if (!found) return found.error();
  return std::move(found->candidates);
}

Result<TracedCandidates> trace_candidates(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio) {
  auto found = find(polygon, centre, min_ratio, true);
  if (!found) return found.error();
  TracedCandidates traced{std::move(found->candidates), {}};
  traced.of_source.assign(found->sources, no_candidate);
  for (std::size_t i = 0; i < found->became.size(); ++i)
    traced.of_source[found->source_of_chord[i]] = found->became[i];
  return traced;
}

}  // namespace evenlift
