// What the candidate stage decides about an edge pair or two opposite vertices, and why.
#include "candidates/pair_candidate.h"
#include "chords/section.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"

namespace evenlift {
namespace {

std::optional<std::uint32_t> candidate_of(const Trace& trace, std::uint32_t source) {
  const std::uint32_t candidate = trace.candidate_of_source[source];
  return candidate == no_index ? std::nullopt : std::optional(candidate);
}

Outcome outcome_of(const PairVerdict& verdict) {
  const bool accepted = verdict.candidate.has_value();
  if (verdict.parallel) return accepted ? Outcome::midpoint : Outcome::parallel_low;
  if (verdict.bisected) return Outcome::bisecting;
  return accepted ? Outcome::nearer_end : Outcome::too_uneven;
}

// For robots with a size.
void find_standing(const Trace& trace, PairDetail& detail) {
  const double near = near_distance(trace.polygon().diameter());
  if (!detail.candidate) {
    detail.standing = Standing::nowhere;
    return;
  }
  const Chord& chord = trace.placement.candidates[*detail.candidate].chord;
  detail.standing = detail.verdict.candidate && same_chord(chord, detail.chosen, near)
                        ? Standing::there
                        : Standing::elsewhere;
  detail.chosen = chord;
}

}  // namespace

std::string_view name(Outcome outcome) {
  switch (outcome) {
    case Outcome::bisecting:
      return "bisecting";
    case Outcome::nearer_end:
      return "nearer_end";
    case Outcome::too_uneven:
      return "too_uneven";
    case Outcome::midpoint:
      return "midpoint";
    case Outcome::parallel_low:
      return "parallel_low";
  }
  return {};
}

PairDetail look_at_pair(const Trace& trace, std::uint32_t index) {
  const Polygon& polygon = trace.polygon();
  const Vec2& centre = trace.centre;
  PairDetail detail;
  detail.pair = trace.pairs[index];
  const SeenEdge a = see(polygon, centre, detail.pair.a), b = see(polygon, centre, detail.pair.b);
  detail.verdict = examine(polygon, centre, a, b, detail.pair, trace.placement.settings.min_ratio);
  detail.outcome = outcome_of(detail.verdict);

  const SectionRim begin =
      section_rim(polygon, centre, a, b, detail.pair.begin_a, detail.pair.begin_b);
  const SectionRim end = section_rim(polygon, centre, a, b, detail.pair.end_a, detail.pair.end_b);
  detail.a = {begin.on_a, end.on_a};
  detail.b = {begin.on_b, end.on_b};
  detail.ends = {begin.chord, end.chord};
  detail.reflected = {2 * centre - b.first, 2 * centre - b.last};
  if (!detail.verdict.parallel) detail.meeting = centre + bisecting_offset(centre, a, b);
  // As the candidate stage does, by g alone.
  const auto evenness = [](double g) { return g < 1 ? g : 1 / g; };
  detail.nearer = evenness(detail.verdict.g0) > evenness(detail.verdict.g1) ? 0 : 1;

  // The candidate if the minimum ratio were 0.
  if (detail.verdict.candidate) {
    detail.chosen = detail.verdict.candidate->chord;
  } else {
    detail.chosen = examine(polygon, centre, a, b, detail.pair, 0).candidate->chord;
  }
  detail.candidate = candidate_of(trace, index);
  detail.stands = detail.candidate && trace.source_of_candidate[*detail.candidate] == index;
  if (trace.placement.stands) find_standing(trace, detail);
  return detail;
}

RangeDetail look_at_range(const Trace& trace, std::uint32_t index) {
  RangeDetail detail;
  detail.pair = trace.pairs[trace.ranges[index]];
  const double min_ratio = trace.placement.settings.min_ratio;
  if (const Stands* stands = trace.placement.stands.get()) {
    const auto ranges = standing_ranges(trace.polygon(), trace.centre, detail.pair.a, detail.pair.b,
                                        min_ratio, *stands);
    detail.range = ranges[longest_range(ranges, near_distance(trace.polygon().diameter()))];
  } else {
    detail.range = *range_of(trace.polygon(), trace.centre, detail.pair, min_ratio);
  }
  detail.ends = {chord_at(trace.centre, detail.range, detail.range.first),
                 chord_at(trace.centre, detail.range, detail.range.last)};
  detail.candidates = trace.candidates_of_range[index];
  return detail;
}

OppositeDetail look_at_opposite(const Trace& trace, std::uint32_t index) {
  const auto source = static_cast<std::uint32_t>(trace.pairs.size()) + index;
  OppositeDetail detail;
  detail.vertices = trace.opposite[index];
  detail.chord = opposite_chord(trace.polygon(), trace.centre, detail.vertices).chord;
  detail.candidate = candidate_of(trace, source);
  detail.stands = detail.candidate && trace.source_of_candidate[*detail.candidate] == source;
  return detail;
}

}  // namespace evenlift
