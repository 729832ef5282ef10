#include <algorithm>
#include <array>
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
#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// The unsorted candidates, the best of each source first. Until the end, a candidate's `source` is
// its number here.
struct FoundStanding {
  struct Origin {
    std::uint32_t source;
    bool in_range;  // from positions anywhere in the range
  };
  std::vector<Candidate> candidates;
  std::vector<Origin> origins;  // by candidate
  std::uint32_t sources = 0;
  void add(const std::vector<Candidate>& some, std::uint32_t source, bool in_range) {
    for (const Candidate& candidate : some) {
      candidates.push_back(candidate);
      candidates.back().source = static_cast<std::uint32_t>(origins.size());
      origins.push_back({source, in_range});
    }
  }
};

struct Wanted {
  const Polygon& polygon;
  Vec2 centre;
  double min_ratio;
  const Stands& stands;
  Positions positions;
  double near;
  FromCorners from_corners;
};

void add_pair(const Wanted& wanted, const EdgePair& pair, FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  found.add(standing_chords(polygon, stands, centre, pair, min_ratio), found.sources, false);
  if (positions != Positions::range) return;
  const auto a = stand_line(polygon, centre, stands, pair.a);
  const auto b = stand_line(polygon, centre, stands, pair.b);
  if (a && b)
    found.add(standing_range_chords(from_corners, centre, *a, *b, min_ratio, near), found.sources,
              true);
}

// For hands without depth: the edge pairs and opposite vertices of the polygon.
std::optional<InputError> find_on_outline(const Wanted& wanted, FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  const RadialView view(polygon, centre);
  const std::uint64_t pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(pairs, "edge pairs")) return error;
  const auto opposite = find_opposite_vertices(polygon, centre, view, max_edge_pairs - pairs);
  if (!opposite) return too_many_opposite_vertices();
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    if (found.candidates.size() <= max_edge_pairs) add_pair(wanted, pair, found);
    ++found.sources;
  });
  for (const OppositeVertices& two : *opposite) {
    const Candidate candidate = opposite_chord(polygon, centre, two);
    if (!stands.has_body() && reaches(candidate.chord, min_ratio) && can_stand(stands, candidate))
      found.add({candidate}, found.sources, false);
    ++found.sources;
  }
  return std::nullopt;
}

struct NumberedPair {
  std::array<std::uint32_t, 2> edges;
  std::uint32_t number;
};

// The edge pairs of the polygon, which are the sources of chords between moved edges.
std::vector<NumberedPair> numbered_pairs(const Polygon& polygon, const RadialView& view) {
  std::vector<NumberedPair> pairs;
  for_each_edge_pair(polygon, view, [&](const EdgePair& pair) {
    pairs.push_back({{std::min(pair.a, pair.b), std::max(pair.a, pair.b)},
                     static_cast<std::uint32_t>(pairs.size())});
  });
  sort_items(pairs, [](const NumberedPair& a, const NumberedPair& b) {
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
  return at != pairs.end() && at->edges == edges ? at->number : no_index;
}

void add_lines(const Wanted& wanted, const StandLine& a, const StandLine& b, std::uint32_t source,
               FoundStanding& found) {
  const auto& [polygon, centre, min_ratio, stands, positions, near, from_corners] = wanted;
  found.add(standing_chords(stands, centre, a, b, min_ratio, near), source, false);
  if (positions == Positions::range)
    found.add(standing_range_chords(from_corners, centre, a, b, min_ratio, near), source, true);
}

// For hands with depth: the edges, moved inward.
std::optional<InputError> find_on_moved_edges(const Wanted& wanted, FoundStanding& found) {
  const Polygon& polygon = wanted.polygon;
  const Vec2& centre = wanted.centre;
  const RadialView view(polygon, centre);
  const std::uint64_t outline_pairs = count_edge_pairs(polygon, view);
  if (auto error = check_number(outline_pairs, "edge pairs")) return error;
  const auto opposite =
      find_opposite_vertices(polygon, centre, view, max_edge_pairs - outline_pairs);
  if (!opposite) return too_many_opposite_vertices();
  const std::vector<NumberedPair> numbers = numbered_pairs(polygon, view);
  found.sources = static_cast<std::uint32_t>(numbers.size() + opposite->size());
  std::vector<StandLine> lines;
  for (std::uint32_t edge = 0; edge < polygon.size(); ++edge)
    if (const auto line = stand_line(polygon, centre, wanted.stands, edge)) lines.push_back(*line);
  std::uint64_t pairs = 0;
  for_each_facing(lines, wanted.near, [&](std::uint32_t i, std::uint32_t j) {
    add_lines(wanted, lines[i], lines[j], number_of_pair(numbers, lines[i].edge, lines[j].edge),
              found);
    return ++pairs <= max_edge_pairs && found.candidates.size() <= max_edge_pairs;
  });
  return check_number(pairs, "pairs of edges, moved inward,");
}

void note_sources(const FoundStanding& found, const std::vector<std::uint32_t>& became_of,
                  Positions positions, TracedCandidates& traced) {
  traced.of_source.assign(found.sources, no_index);
  if (positions == Positions::range)
    traced.ranges_of_source.assign(found.sources, {no_index, no_index});
  for (std::size_t i = 0; i < found.origins.size(); ++i) {
    const auto& [source, in_range] = found.origins[i];
    if (source == no_index) continue;
    std::uint32_t& of_pair = traced.of_source[source];
    if (!in_range && of_pair == no_index) of_pair = became_of[i];
    if (!in_range) continue;
    auto& ranges = traced.ranges_of_source[source];
    ranges[ranges[0] == no_index ? 0 : 1] = became_of[i];
  }
  for (auto& [first, last] : traced.ranges_of_source)
    if (last < first) std::swap(first, last);
}

}  // namespace

Result<TracedCandidates> standing_candidates(const Polygon& polygon, const Vec2& centre,
                                             double min_ratio, const Stands& stands,
                                             Positions positions, double clear) {
  const double near = near_distance(polygon.diameter());
  const Corners corners(polygon);
  const Wanted wanted{
      polygon, centre, min_ratio, stands, positions, near, {polygon, corners, clear, &stands}};
  FoundStanding found;
  const bool on_outline = stands.robot().depth == 0;
  if (auto error = on_outline ? find_on_outline(wanted, found) : find_on_moved_edges(wanted, found))
    return *error;
  if (auto error = check_number(found.candidates.size(), "candidates")) return *error;
  std::vector<Candidate> ordered = in_candidate_order(found.candidates, near);
  std::vector<std::uint32_t> number;  // in `found`
  for (const Candidate& candidate : ordered) number.push_back(candidate.source);
  MergedCandidates merged = merge_duplicates(std::move(ordered), near);
  std::vector<std::uint32_t> became_of(number.size());
  for (std::size_t i = 0; i < number.size(); ++i) became_of[number[i]] = merged.became[i];
  TracedCandidates traced{std::move(merged.candidates), {}, {}};
  for (Candidate& candidate : traced.candidates)
    candidate.source = found.origins[candidate.source].source;
  note_sources(found, became_of, positions, traced);
  return traced;
}

}  // namespace evenlift
