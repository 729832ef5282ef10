#include "evenlift/trace.h"

#include "evenlift/placed_robots.h"

#include <algorithm>
#include <string>

#include "chords/radial_view.h"
#include "evenlift/selection.h"
#include "evenlift/stability.h"
#include "evenlift/stands.h"
#include "evenlift/swaps.h"
#include "evenlift/tolerance.h"
#include "evenlift/wording.h"
#include "trace/step_rows.h"

namespace evenlift {
namespace {

// In the order of the sweep that finds the chords. The sweep lists a chord between two vertices at
// the forward one, `rays` also at the backward one.
Trace::Rays make_rays(const Polygon& polygon, const Vec2& centre,
                      const std::vector<VertexChord>& chords) {
  const RadialView view(polygon, centre);
  Trace::Rays rays;
  rays.begins.push_back(0);
  std::size_t next = 0;
  const auto add = [&](std::uint32_t vertex) {
    rays.vertices.push_back(vertex);
    for (; next < chords.size() && chords[next].vertex == vertex; ++next)
      rays.chords.push_back(chords[next]);
    rays.begins.push_back(static_cast<std::uint32_t>(rays.chords.size()));
  };
  for (std::uint32_t group = 0; group < view.direction_count(); ++group) {
    const std::uint32_t begin = view.group_begin(group), end = view.group_begin(group + 1);
    const std::size_t first_ray = rays.vertices.size();
    for (std::uint32_t k = begin; k < end; ++k)
      if (view.forward(view.order()[k])) add(view.order()[k]);
    const std::size_t first_backward = rays.vertices.size();
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t vertex = view.order()[k];
      if (view.forward(vertex)) continue;
      for (std::uint32_t i = rays.begins[first_ray]; i < rays.begins[first_backward]; ++i)
        if (rays.chords[i].hit_vertex == vertex) rays.chords.push_back(rays.chords[i]);
      add(vertex);
    }
  }
  return rays;
}

class BlockWriter {
 public:
  explicit BlockWriter(Trace& trace) : trace_(trace) {}

  void add(Chapter chapter, std::initializer_list<StepKind> kinds, std::uint64_t items = 1,
           std::uint32_t first_item = 0) {
    if (items == 0) return;
    Trace::Block block;
    block.first = static_cast<std::uint32_t>(steps_);
    block.items = static_cast<std::uint32_t>(items);
    block.first_item = first_item;
    block.kinds = static_cast<std::uint32_t>(kinds.size());
    std::copy(kinds.begin(), kinds.end(), block.kind.begin());
    block.chapter = chapter;
    steps_ += items * kinds.size();
    trace_.blocks.push_back(block);
  }
  std::uint64_t steps() const { return steps_; }

 private:
  Trace& trace_;
  std::uint64_t steps_ = 0;
};

void write_candidates(const Trace& trace, BlockWriter& blocks) {
  blocks.add(Chapter::vertex_chords, {StepKind::radial}, !trace.radial_edges.empty());
  blocks.add(Chapter::vertex_chords, {StepKind::ray}, trace.rays.vertices.size());
  blocks.add(Chapter::slopes, {StepKind::slopes});
  blocks.add(Chapter::pairs, {StepKind::sections, StepKind::outcome}, trace.pairs.size());
  blocks.add(Chapter::pairs, {StepKind::opposite}, trace.opposite.size());
  blocks.add(Chapter::pairs, {StepKind::range}, trace.ranges.size());
  // With a size, a pair may offer several chords, without a step for each.
  blocks.add(Chapter::pairs, {StepKind::duplicates}, trace.placement.stands ? 0 : 1);
  blocks.add(Chapter::candidates, {StepKind::candidates});
}

void write_teams(const Trace& trace, BlockWriter& blocks, std::initializer_list<StepKind> choice) {
  const Placement& placement = trace.placement;
  const auto teams = static_cast<std::uint32_t>(placement.teams.size());
  blocks.add(Chapter::first_team, {StepKind::directions},
             placement.settings.method == Method::distributed);
  blocks.add(Chapter::first_team, choice, std::min(teams, 1u));
  blocks.add(Chapter::further_teams, choice, teams - std::min(teams, 1u), 1);
  const Chapter last = teams > 1 ? Chapter::further_teams : Chapter::first_team;
  blocks.add(last, {StepKind::fewer}, teams == 0 || teams < placement.requested_teams);
}

void write_rounds(const BalancedHistory& history, BlockWriter& blocks) {
  const auto moves_of = [&](std::uint32_t round) {
    return static_cast<std::uint32_t>(
        std::count_if(history.moves.begin(), history.moves.end(),
                      [&](const BalancedMove& move) { return move.round == round; }));
  };
  std::uint32_t first = 0;
  for (std::uint32_t round = 0; round < history.rounds; ++round) {
    const std::uint32_t moves = moves_of(round);
    blocks.add(Chapter::exchange, {StepKind::exchange}, moves, first);
    blocks.add(Chapter::exchange, {StepKind::round}, moves > 0, round);
    first += moves;
  }
  blocks.add(Chapter::exchange, {StepKind::settled}, history.rounds > 0);
}

void write_balanced(const Trace& trace, BlockWriter& blocks) {
  const BalancedHistory& history = trace.history;
  const auto has = [&](StepKind kind) {
    return balanced_set_at(trace, {kind, Chapter::law, 0}) != nullptr;
  };
  blocks.add(Chapter::law, {StepKind::lever}, has(StepKind::lever));
  blocks.add(Chapter::law, {StepKind::three}, has(StepKind::three));
  blocks.add(Chapter::law, {StepKind::many},
             has(StepKind::many) && trace.placement.settings.robots > 3);
  for (const StepKind kind : {StepKind::rest, StepKind::mirror, StepKind::completion})
    blocks.add(Chapter::start, {kind}, has(kind));
  blocks.add(Chapter::start, {StepKind::start}, history.start.size());
  blocks.add(Chapter::start, {StepKind::fewer}, !history.found);
  write_rounds(history, blocks);
}

void write_failures(const Trace& trace, BlockWriter& blocks) {
  const std::uint32_t robots = trace.placement.settings.robots;
  if (robots < 3 || robots > most_failing) return;
  blocks.add(Chapter::failures, {StepKind::failure}, robots);
  blocks.add(Chapter::failures, {StepKind::failures});
  blocks.add(Chapter::failures, {StepKind::pairs}, trace.in_pairs.has_value());
}

void write_loads_of_supports(const Placement& placement, BlockWriter& blocks) {
  const bool determined = loads_are_determined(placement), carried = placement.loads.has_value();
  const std::size_t robots = count_robots(placement.teams);
  blocks.add(Chapter::loads, {StepKind::equations});
  blocks.add(Chapter::loads, {StepKind::by_lever}, carried && determined && robots == 2);
  blocks.add(Chapter::loads, {StepKind::by_areas}, carried && determined && robots == 3);
  blocks.add(Chapter::loads, {StepKind::by_springs}, carried && !determined);
  blocks.add(Chapter::loads, {StepKind::falls}, !carried);
}

void write_blocks_of_method(const Trace& trace, BlockWriter& blocks) {
  if (trace.balanced()) return write_balanced(trace, blocks);
  if (trace.given())
    return blocks.add(Chapter::robots, {StepKind::support}, count_robots(trace.placement.teams));
  if (!trace.by_candidates()) return write_teams(trace, blocks, {StepKind::team, StepKind::base});
  write_candidates(trace, blocks);
  write_teams(trace, blocks, {StepKind::scores, StepKind::team, StepKind::base});
  if (!trace.swaps || trace.placement.teams.empty()) return;
  blocks.add(Chapter::swaps, {StepKind::swap}, trace.swaps->swaps.size());
  blocks.add(Chapter::swaps, {StepKind::held});
}

std::uint64_t write_blocks(Trace& trace) {
  const Placement& placement = trace.placement;
  BlockWriter blocks(trace);
  blocks.add(Chapter::object, {StepKind::polygon});
  blocks.add(Chapter::object, {StepKind::centroid});
  blocks.add(Chapter::object, {StepKind::cargo}, placement.settings.cargo.size());
  blocks.add(Chapter::object, {StepKind::centre});
  blocks.add(Chapter::object, {StepKind::stands}, placement.stands ? 1 : 0);
  write_blocks_of_method(trace, blocks);
  if (!placement.teams.empty()) {
    if (trace.given()) write_loads_of_supports(placement, blocks);
    const bool in_teams = !is_one_team(placement.settings.method);
    blocks.add(Chapter::loads, {StepKind::share}, in_teams ? placement.teams.size() : 0);
    blocks.add(Chapter::loads, {StepKind::loads}, placement.loads.has_value());
    const bool by_springs = trace.given() && placement.loads && !loads_are_determined(placement);
    blocks.add(Chapter::loads, {StepKind::extremes}, by_springs);
    if (trace.balanced()) write_failures(trace, blocks);
    blocks.add(Chapter::grasp, {StepKind::coverage});
    blocks.add(Chapter::grasp, {StepKind::contacts});
    blocks.add(Chapter::grasp, {StepKind::cut}, trace.contacts.size());
    blocks.add(Chapter::grasp, {StepKind::slide});
    blocks.add(Chapter::grasp, {StepKind::closure});
    blocks.add(Chapter::grasp, {StepKind::second_order}, !placement.closure.form_closure);
  }
  blocks.add(Chapter::grasp, {StepKind::result});
  return blocks.steps();
}

std::optional<InputError> check_steps(std::uint64_t steps) {
  if (steps <= max_trace_steps) return std::nullopt;
  return InputError{
      ErrorCode::unsupported,
      say("the algorithm takes at least {steps} steps here, more than the {most} that can be shown",
          {std::to_string(steps), max_trace_steps})};
}

std::optional<InputError> collect_candidates(Trace& trace) {
  const double min_ratio = trace.placement.settings.min_ratio;
  const Positions positions = trace.placement.settings.positions;
  const Stands* stands = trace.placement.stands.get();
  const double clear = hold_requirements(trace.placement).clear;
  auto traced =
      stands
          ? standing_candidates(trace.polygon(), trace.centre, min_ratio, *stands, positions, clear)
          : trace_candidates(trace.polygon(), trace.centre, min_ratio, positions, clear);
  if (!traced) return traced.error();
  trace.candidate_of_source = std::move(traced->of_source);
  for (std::uint32_t source = 0; source < traced->ranges_of_source.size(); ++source) {
    const auto& candidates = traced->ranges_of_source[source];
    if (candidates[0] == no_index) continue;
    trace.ranges.push_back(source);
    trace.candidates_of_range.push_back(candidates);
  }
  for (const Candidate& candidate : traced->candidates)
    trace.source_of_candidate.push_back(candidate.source);
  trace.first_source_of_candidate.assign(traced->candidates.size(), no_index);
  for (std::uint32_t source = 0; source < trace.candidate_of_source.size(); ++source) {
    const std::uint32_t candidate = trace.candidate_of_source[source];
    if (candidate != no_index && trace.first_source_of_candidate[candidate] == no_index)
      trace.first_source_of_candidate[candidate] = source;
  }
  return std::nullopt;
}

std::optional<InputError> collect(Trace& trace) {
  if (auto error = check_steps(2 * count_edge_pairs(trace.polygon(), trace.centre))) return error;
  auto chords = vertex_chords(trace.polygon(), trace.centre);
  if (!chords) return chords.error();
  auto pairs = edge_pairs(trace.polygon(), trace.centre);
  if (!pairs) return pairs.error();
  auto opposite = opposite_vertices(trace.polygon(), trace.centre);
  if (!opposite) return opposite.error();
  trace.rays = make_rays(trace.polygon(), trace.centre, *chords);
  trace.pairs = *std::move(pairs);
  trace.opposite = *std::move(opposite);
  const std::vector<bool> radial = radial_edges(trace.polygon(), trace.centre);
  for (std::uint32_t edge = 0; edge < radial.size(); ++edge)
    if (radial[edge]) trace.radial_edges.push_back(edge);
  return collect_candidates(trace);
}

std::vector<Team> teams_on(const Placement& placement, const std::vector<std::uint32_t>& taken) {
  return distribute_weight(chords_of(placement.candidates, taken), placement.weight());
}

void trace_swaps(Trace& trace) {
  const Placement& placement = trace.placement;
  const Settings& settings = placement.settings;
  trace.swaps = swap_teams(trace.object(), trace.centre, placement.candidates,
                           select_teams(trace.object(), trace.centre, placement.candidates,
                                        trace.metric(), placement.requested_teams,
                                        first_team(settings.positions), placement.stands.get()),
                           hold_requirements(placement), placement.stands.get());
  trace.stages.push_back(teams_on(placement, trace.swaps->start));
  for (const Swap& swap : trace.swaps->swaps)
    trace.stages.push_back(teams_on(placement, swap.taken));
}

}  // namespace

Result<Trace> make_trace(const Placement& placement, HistoryLength length, const Units& units) {
  // Teams are shown where the method placed them.
  if (!placement.moved.teams.empty()) {
    const auto found = place(placement.object, placement.own_centre, placement.settings);
    if (!found) return found.error();
    Result<Trace> trace = make_trace(*found, length, units);
    if (trace) trace->moved = placement;
    return trace;
  }
  if (placement.settings.method == Method::given && placement.teams.empty())
    return bad_setting("supports", "no support stands beneath the object or at its edge");
  if (const auto centre = check_centre_of_mass(placement.polygon(), placement.centre_of_mass);
      !centre)
    return centre.error();
  Trace trace{.placement = placement,
              .centre = placement.centre_of_mass,
              .units = units,
              .rays = {},
              .radial_edges = {},
              .pairs = {},
              .opposite = {},
              .candidate_of_source = {},
              .source_of_candidate = {},
              .first_source_of_candidate = {},
              .ranges = {},
              .candidates_of_range = {},
              .swaps = {},
              .stages = {},
              .contacts = {},
              .problem = {},
              .history = {},
              .robot_numbers = {},
              .in_pairs = {},
              .report_of_pairs = {},
              .report = {},
              .moved = {},
              .blocks = {}};
  if (placement.moved.any()) trace.moved = placement;
  if (placement.settings.method == Method::balanced)
    if (auto error = trace_search(trace, length)) return *error;
  if (trace.by_candidates())
    if (auto error = collect(trace)) return *error;
  // During a drag the page does not swap teams, so neither does the trace.
  if (swaps_teams(placement.settings) && placement.search_ended) trace_swaps(trace);
  trace.contacts = contacts(trace.polygon(), contact_points(trace.placement));
  if (auto error = check_steps(write_blocks(trace))) return *error;
  trace.report = report_of(trace.placement, {.models = placement.settings.method == Method::given,
                                             .failures = trace.count(StepKind::failure) > 0});
  return trace;
}

std::uint32_t Trace::size() const {
  const Block& last = blocks.back();
  return last.first + last.items * last.kinds;
}

Step Trace::step(std::uint32_t k) const {
  std::size_t b = blocks.size() - 1;
  while (b > 0 && blocks[b].first > k) --b;
  const Block& block = blocks[b];
  const std::uint32_t offset = k - block.first;
  return {block.kind[offset % block.kinds], block.chapter, block.first_item + offset / block.kinds};
}

std::uint32_t Trace::count(StepKind kind) const {
  std::uint32_t number = 0;
  for (const Block& block : blocks)
    for (std::uint32_t i = 0; i < block.kinds; ++i)
      if (block.kind[i] == kind) number += block.items;
  return number;
}

std::optional<std::uint32_t> Trace::find(StepKind kind, std::uint32_t item) const {
  for (const Block& block : blocks) {
    if (item < block.first_item || item - block.first_item >= block.items) continue;
    for (std::uint32_t i = 0; i < block.kinds; ++i)
      if (block.kind[i] == kind) return block.first + (item - block.first_item) * block.kinds + i;
  }
  return std::nullopt;
}

std::optional<std::uint32_t> Trace::chapter_begin(Chapter chapter) const {
  for (const Block& block : blocks)
    if (block.chapter == chapter) return block.first;
  return std::nullopt;
}

bool Trace::by_candidates() const { return selects_candidates(placement.settings.method); }

Metric Trace::metric() const { return *metric_of(placement.settings.method); }

std::uint32_t nearest_step(const Trace& trace, const Step& step) {
  if (const auto same = trace.find(step.kind, step.item)) return *same;
  if (const std::uint32_t number = trace.count(step.kind))
    return trace.find(step.kind, std::min(step.item, number - 1)).value_or(0);
  for (const Trace::Block& block : trace.blocks)
    if (block.chapter >= step.chapter) return block.first;
  return trace.size() - 1;
}

Progress progress_at(const Trace& trace, std::uint32_t k) {
  // Steps of a kind up to step k.
  const auto number = [&](StepKind kind) {
    std::uint32_t steps = 0;
    for (const Trace::Block& block : trace.blocks) {
      if (block.first > k) break;
      for (std::uint32_t i = 0; i < block.kinds; ++i)
        if (block.kind[i] == kind)
          steps += std::min(block.items, (k - block.first + block.kinds - i) / block.kinds);
    }
    return steps;
  };
  Progress progress;
  progress.stands = number(StepKind::stands) > 0;
  progress.rays = number(StepKind::ray);
  progress.slopes = number(StepKind::slopes) > 0;
  progress.sections = number(StepKind::sections);
  progress.sources = number(StepKind::outcome) + number(StepKind::opposite);
  progress.merged = number(StepKind::duplicates) + number(StepKind::candidates) > 0;
  progress.teams = number(StepKind::team);
  progress.base_teams = number(StepKind::base);
  progress.swaps = number(StepKind::swap);
  progress.shares = number(StepKind::share);
  progress.robots = number(StepKind::support);
  if (trace.given()) {  // one team, complete with its last robot
    const bool all = progress.robots == count_robots(trace.placement.teams);
    progress.teams = progress.base_teams = all ? 1 : 0;
    progress.shares = number(StepKind::loads);
  }
  progress.coverage = number(StepKind::coverage) > 0;
  progress.cuts = number(StepKind::cut);
  progress.closure = number(StepKind::closure) > 0;
  return progress;
}

const std::vector<Team>& teams_at(const Trace& trace, const Progress& known) {
  return trace.stages.empty() ? trace.placement.teams : trace.stages[known.swaps];
}

Points lifting_base(const Trace& trace, std::uint32_t teams) {
  Progress known;
  known.base_teams = teams;
  return lifting_base(trace, known);
}

Points lifting_base(const Trace& trace, const Progress& known) {
  const std::vector<Team>& teams = teams_at(trace, known);
  const auto number =
      static_cast<std::ptrdiff_t>(std::min<std::size_t>(known.base_teams, teams.size()));
  return lifting_base(trace.polygon(), lifting_points({teams.begin(), teams.begin() + number}));
}

// The sweep turns left from the x axis, but slopes rise from just after the vertical to the
// vertical. So the chords after the vertical come first.
std::vector<std::uint32_t> chords_by_slope(const Trace& trace) {
  std::vector<std::uint32_t> falling, others;
  for (std::uint32_t i = 0; i < trace.rays.vertices.size(); ++i) {
    const std::uint32_t vertex = trace.rays.vertices[i];
    const Vec2 u = trace.polygon().vertex(vertex) - trace.centre;
    const bool falls = u.x * u.y < 0 && !is_vertical(u);
    for (std::uint32_t c = trace.rays.begins[i]; c < trace.rays.begins[i + 1]; ++c) {
      // Otherwise an earlier ray lists it.
      const VertexChord& chord = trace.rays.chords[c];
      if (chord.vertex == vertex) (falls ? falling : others).push_back(c);
    }
  }
  falling.insert(falling.end(), others.begin(), others.end());
  return falling;
}

}  // namespace evenlift
