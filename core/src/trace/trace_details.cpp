#include <algorithm>

#include "candidates/pair_candidate.h"
#include "chords/radial_view.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "evenlift/trace.h"
#include "polygon/corners.h"
#include "selection/greedy_selector.h"
#include "trace/step_rows.h"

namespace evenlift {

SwapDetail look_at_swap(const Trace& trace, std::uint32_t index) {
  const SwapHistory& history = *trace.swaps;
  const Swap& swap = history.swaps[index];
  const bool first = index == 0;
  const auto& taken = first ? history.start : history.swaps[index - 1].taken;
  SwapDetail detail;
  detail.before = first ? history.keys : history.swaps[index - 1].keys;
  detail.after = swap.keys;
  detail.margin_before = margin_of(trace, lifting_points(trace.stages[index]));
  detail.margin = margin_of(trace, lifting_points(trace.stages[index + 1]));
  detail.teams = swap.teams;
  for (const std::uint32_t team : swap.teams) {
    detail.from.push_back(taken[team]);
    detail.to.push_back(swap.taken[team]);
  }
  detail.kind = swap.kind;
  detail.decided_by = swap.decided_by;
  return detail;
}

// --- Figures of a metric's gain, by the same wedges as the scores.

namespace {

class GainScene {
 public:
  GainScene(const Trace& trace) : trace_(trace) {}

  void add(const EndGain& end) {
    if (!end.outside) return;
    switch (trace_.metric()) {
      case Metric::circle:
        add_triangle(end);
        return add_circle(end);
      case Metric::distance:
        return add_arms(end);
      case Metric::area:
        add_triangle(end);
        return add_part(end);
    }
  }
  std::vector<Figure> take() && { return std::move(out_); }

 private:
  void add_triangle(const EndGain& end) {
    out_.push_back({FigureKind::gain_triangle, {end.h1, end.h2, end.p}, std::nullopt, end.value});
  }

  void add_part(const EndGain& end) {
    Points part = trace_.object().boundary();
    if (!trace_.polygon().counter_clockwise()) std::reverse(part.begin(), part.end());
    part = clip_left(part, end.h2, end.h1);  // beyond the edge of H
    part = clip_left(part, end.h1, end.p);
    part = clip_left(part, end.p, end.h2);
    if (part.size() > 2)
      out_.push_back({FigureKind::gain_part, std::move(part), std::nullopt, end.value});
  }

  void add_circle(const EndGain& end) {
    const double a = length(end.h2 - end.p), b = length(end.p - end.h1),
                 c = length(end.h2 - end.h1);
    const double twice_area = std::fabs(cross(end.h2 - end.h1, end.p - end.h1));
    const Vec2 middle = (a * end.h1 + b * end.h2 + c * end.p) / (a + b + c);
    out_.push_back({FigureKind::gain_circle, {middle}, std::nullopt, twice_area / (a + b + c)});
  }

  void add_arms(const EndGain& end) {
    const Surroundings surroundings(trace_.object(), trace_.centre);
    const Vec2 h1 = end.h1 - trace_.centre, h2 = end.h2 - trace_.centre, p = end.p - trace_.centre;
    const Wedge wedge(surroundings, Metric::distance, h1, h2);
    for (const Wedge::Arm& arm : wedge.arms(p)) {
      add_arm(FigureKind::arm_before, arm.vertex, h1, h2, arm.before);
      add_arm(FigureKind::arm_after, arm.vertex, arm.up_to_p ? h1 : p, arm.up_to_p ? p : h2,
              arm.after);
    }
  }

  // From a vertex outside the line from -> to to its foot.
  void add_arm(FigureKind kind, const Vec2& vertex, const Vec2& from, const Vec2& to,
               double distance) {
    if (!(distance > 0)) return;
    const Vec2 inward = left_normal(to - from) / length(to - from);
    out_.push_back({kind,
                    {trace_.centre + vertex, trace_.centre + vertex + distance * inward},
                    std::nullopt,
                    distance});
  }

  const Trace& trace_;
  std::vector<Figure> out_;
};

}  // namespace

std::vector<Figure> gain_figures(const Trace& trace, const TeamScores& scores,
                                 std::uint32_t candidate) {
  GainScene scene(trace);
  if (scores.rule == Rule::score)
    for (const EndGain& end : scores.of_candidate[candidate].ends) scene.add(end);
  return std::move(scene).take();
}

// --- What the candidate stage decides about an edge pair or two opposite vertices, and why.

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

namespace {

void cut_regions(const Trace& trace, std::uint32_t contacts, StepDetail& detail) {
  const auto some = [&](std::uint32_t number) {
    return std::vector<Contact>(trace.contacts.data(), trace.contacts.data() + number);
  };
  FreeRegions after = free_regions(trace.polygon(), trace.centre, some(contacts));
  detail.clockwise = std::move(after.clockwise);
  detail.counterclockwise = std::move(after.counterclockwise);
  if (contacts < 2) return;
  const FreeRegions before = free_regions(trace.polygon(), trace.centre, some(contacts - 1));
  detail.clockwise_before = before.clockwise.exists;
  detail.counterclockwise_before = before.counterclockwise.exists;
}

void look_at_team(const Trace& trace, StepDetail& detail) {
  const std::uint32_t team = detail.step.item;
  if (trace.by_candidates() && detail.step.kind != StepKind::base)
    detail.scores = look_at_scores(trace, team);
  detail.base_before = lifting_base(trace, team);
  detail.base = lifting_base(trace, team + 1);
}

void look_at_bases_of_swap(const Trace& trace, StepDetail& detail) {
  Progress known;
  known.base_teams = static_cast<std::uint32_t>(trace.placement.teams.size());
  known.swaps = detail.step.item;
  detail.base_before = lifting_base(trace, known);
  ++known.swaps;
  detail.base = lifting_base(trace, known);
}

}  // namespace

bool centre_is_outside(const Trace& trace) {
  const Vec2& c = trace.centre;
  bool outside = true;
  for (std::size_t i = 0; i < trace.polygon().size(); ++i) {
    const Vec2 &p = trace.polygon().edge_start(i), &q = trace.polygon().edge_end(i);
    const double side = orient(p, q, c);
    const bool within_x = (p.x <= c.x) == (c.x <= q.x);
    const bool within_y = (p.y <= c.y) == (c.y <= q.y);
    if (side == 0 && within_x && within_y) return false;
    // Half-open: a vertex to the left of C counts for one of its edges.
    if ((p.y > c.y) != (q.y > c.y) && (side > 0) == (q.y > p.y)) outside = !outside;
  }
  return outside;
}

StepDetail look_at(const Trace& trace, std::uint32_t k) {
  StepDetail detail;
  detail.number = k;
  detail.step = trace.step(k);
  const std::uint32_t item = detail.step.item;
  if (trace.balanced()) look_at_balanced(trace, detail);
  switch (detail.step.kind) {
    case StepKind::sections:
    case StepKind::outcome:
      detail.pair = look_at_pair(trace, item);
      break;
    case StepKind::opposite:
      detail.opposite = look_at_opposite(trace, item);
      break;
    case StepKind::stands:
      detail.stands = look_at_stands(trace);
      break;
    case StepKind::range:
      detail.range = look_at_range(trace, item);
      break;
    case StepKind::swap:
      look_at_bases_of_swap(trace, detail);
      detail.swap = look_at_swap(trace, item);
      break;
    case StepKind::scores:
    case StepKind::team:
    case StepKind::base:
      look_at_team(trace, detail);
      break;
    case StepKind::contacts:
      cut_regions(trace, 0, detail);
      break;
    case StepKind::cut:
      cut_regions(trace, item + 1, detail);
      break;
    default:
      break;
  }
  return detail;
}

}  // namespace evenlift
