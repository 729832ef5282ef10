// The candidates of robots with a size.
#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "candidates/candidate_order.h"
#include "candidates/duplicates.h"
#include "candidates/facing_lines.h"
#include "candidates/pair_candidate.h"
#include "candidates/stand_lines.h"
#include "chords/opposite_vertices.h"
#include "chords/radial_view.h"
#include "evenlift/candidates.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// What was found, before it is in order. Each candidate knows its source.
struct Found {
  std::vector<Candidate> candidates;
  std::uint32_t sources = 0;
  void add(std::vector<Candidate> some, std::uint32_t source) {
    for (Candidate& candidate : some) {
      candidate.source = source;
      candidates.push_back(candidate);
    }
  }
};

// For hands without depth: the pairs of edges and the opposite vertices of the polygon itself.
std::optional<InputError> find_on_outline(const Polygon& polygon, const Vec2& centre,
                                          double min_ratio, const Stands& stands, Found& found) {
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge-pairs")) return error;
  const auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    if (found.candidates.size() <= max_edge_pairs)
      found.add(standing_chords(polygon, stands, centre, pair, min_ratio), found.sources);
    ++found.sources;
  });
  for (const OppositeVertices& two : *opposite) {
    const Candidate candidate = opposite_chord(polygon, centre, two);
    if (!stands.has_body() && reaches(candidate.chord, min_ratio) && can_stand(stands, candidate))
      found.add({candidate}, found.sources);
    ++found.sources;
  }
  return std::nullopt;
}

// Two edges, and the number of their edge-pair.
struct NumberedPair {
  std::array<std::uint32_t, 2> edges;
  std::uint32_t number;
};

// The edge-pairs of the polygon itself, to tell where a chord between moved edges comes from.
std::vector<NumberedPair> numbered_pairs(const Polygon& polygon, const RadialView& view) {
  std::vector<NumberedPair> pairs;
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    pairs.push_back({{std::min(pair.a, pair.b), std::max(pair.a, pair.b)},
                     static_cast<std::uint32_t>(pairs.size())});
  });
  std::sort(pairs.begin(), pairs.end(), [](const NumberedPair& a, const NumberedPair& b) {
    return a.edges != b.edges ? a.edges < b.edges : a.number < b.number;
  });
  return pairs;
}

std::uint32_t number_of_pair(const std::vector<NumberedPair>& pairs, std::uint32_t a,
                             std::uint32_t b) {
  const std::array edges{std::min(a, b), std::max(a, b)};
  const auto at = std::lower_bound(
      pairs.begin(), pairs.end(), edges,
      [](const NumberedPair& pair, const auto& wanted) { return pair.edges < wanted; });
  return at != pairs.end() && at->edges == edges ? at->number : no_candidate;
}

// For hands with depth: the edges, moved inward.
std::optional<InputError> find_on_moved_edges(const Polygon& polygon, const Vec2& centre,
                                              double min_ratio, const Stands& stands,
                                              Found& found) {
  const double near = near_distance(polygon.diagonal());
  const RadialView view(polygon, centre);
  const std::uint64_t outline_pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(outline_pairs, "edge-pairs")) return error;
  const auto opposite =
      find_opposite_vertices(polygon, centre, view, max_edge_pairs - outline_pairs);
  if (!opposite) return too_many_opposite_vertices();
  const std::vector<NumberedPair> numbers = numbered_pairs(polygon, view);
  found.sources = static_cast<std::uint32_t>(numbers.size() + opposite->size());
  std::vector<StandLine> lines;
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge)
    if (const auto line = stand_line(polygon, centre, stands, edge)) lines.push_back(*line);
  std::uint64_t pairs = 0;
  for_each_facing(lines, near, [&](std::uint32_t i, std::uint32_t j) {
    found.add(standing_chords(stands, centre, lines[i], lines[j], min_ratio, near),
              number_of_pair(numbers, lines[i].edge, lines[j].edge));
    return ++pairs <= max_edge_pairs && found.candidates.size() <= max_edge_pairs;
  });
  return check_number(pairs, "pairs of edges, moved inward,");
}

}  // namespace

Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands) {
  Found found;
  const bool on_outline = stands.robot().depth == 0;
  if (auto error = on_outline ? find_on_outline(polygon, centre, min_ratio, stands, found)
                              : find_on_moved_edges(polygon, centre, min_ratio, stands, found))
    return *error;
  if (auto error = check_number(found.candidates.size(), "candidates")) return *error;
  std::vector<Candidate> ordered = in_candidate_order(found.candidates);
  std::vector<std::uint32_t> sources;
  for (const Candidate& candidate : ordered) sources.push_back(candidate.source);
  MergedCandidates merged = merge_duplicates(std::move(ordered), near_distance(polygon.diagonal()));
  TracedCandidates traced{std::move(merged.candidates), {}};
  traced.of_source.assign(found.sources, no_candidate);
  // Of several candidates of one pair the first, by the number of its source alone.
  for (std::size_t i = sources.size(); i-- > 0;)
    if (sources[i] != no_candidate) traced.of_source[sources[i]] = merged.became[i];
  return traced;
}

}  // namespace evenlift
