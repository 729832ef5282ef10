#include "evenlift/candidates.h"

#include "candidate_seeds.h"
#include "duplicates.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "pair_candidate.h"
#include "radial_view.h"

namespace evenlift {
namespace {

SeenEdge see(const Polygon& polygon, const Vec2& centre, std::uint32_t edge) {
  const Vec2 &p = polygon.edge_start(edge), &q = polygon.edge_end(edge);
  const double area = orient(centre, p, q);
  if (area > 0) return {edge, p, q, area};
  return {edge, q, p, -area};
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
                                               double min_ratio,
                                               std::vector<std::uint32_t>* of_pairs) {
  const RadialView view(polygon, centre);
  if (auto error = check_number(count_edge_pairs(polygon, view), "edge-pairs")) return *error;
  CandidateSeeds seeds(polygon, centre, view, min_ratio, of_pairs);
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) { seeds.add(pair); });
  std::vector<Candidate> candidates = seeds.grow();
  merge_duplicates(candidates, near_distance(polygon.diagonal()), of_pairs);
  return candidates;
}

}  // namespace evenlift
