#include "evenlift/candidates.h"

#include <utility>

#include "candidates/candidate_seeds.h"
#include "candidates/duplicates.h"
#include "candidates/pair_candidate.h"
#include "chords/opposite_vertices.h"
#include "chords/radial_view.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

struct Found {
  std::vector<Candidate> candidates;
  std::uint32_t sources = 0;
  std::vector<std::uint32_t> source_of_chord;  // if traced: the source of each chord before merging
  std::vector<std::uint32_t> became;           // and the candidate that the chord led to
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
  std::vector<Candidate> chords = seeds.grow();
  found.sources = static_cast<std::uint32_t>(pairs + opposite->size());
  if (traced)
    for (const Candidate& c : chords) found.source_of_chord.push_back(c.source);
  MergedCandidates merged = merge_duplicates(std::move(chords), near_distance(polygon.diagonal()));
  found.candidates = std::move(merged.candidates);
  found.became = std::move(merged.became);
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
    case CandidateKind::range:
      return "range";
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
