#include <algorithm>
#include <iterator>

#include "evenlift/main_steps.h"
#include "evenlift/trace.h"
#include "exact/sorted_indices.h"
#include "trace/step_rows.h"

namespace evenlift {
namespace {

constexpr std::string_view chapter_names[] = {
    "object",   "law",        "robots",     "vertex_chords", "slopes",
    "pairs",    "candidates", "first_team", "further_teams", "start",
    "exchange", "swaps",      "loads",      "failures",      "grasp"};
static_assert(std::size(chapter_names) == chapter_count);

// The words are in a row of output/trace_words/step_words.cpp.
struct StepRow {
  StepKind kind;
  std::string_view name;
  void (StepNumbers::*numbers)();
  void (StepFigures::*figures)();
};

using N = StepNumbers;
using F = StepFigures;
// clang-format off
constexpr StepRow steps[] = {
    {StepKind::polygon,      "polygon",      &N::polygon,      &F::polygon},
    {StepKind::centroid,     "centroid",     &N::centroid,     &F::centroid},
    {StepKind::centre,       "centre",       &N::centre,       &F::centre},
    {StepKind::radial,       "radial",       &N::radial,       &F::radial},
    {StepKind::ray,          "ray",          &N::ray,          &F::ray},
    {StepKind::slopes,       "slopes",       &N::slopes,       &F::slopes},
    {StepKind::sections,     "sections",     &N::sections,     &F::sections},
    {StepKind::outcome,      "outcome",      &N::outcome,      &F::outcome},
    {StepKind::opposite,     "opposite",     &N::opposite,     &F::opposite},
    {StepKind::duplicates,   "duplicates",   &N::duplicates,   &F::candidates},
    {StepKind::candidates,   "candidates",   &N::candidates,   &F::candidates},
    {StepKind::directions,   "directions",   &N::directions,   &F::none},
    {StepKind::scores,       "scores",       &N::scores,       &F::scores},
    {StepKind::team,         "team",         &N::team,         &F::team},
    {StepKind::base,         "base",         &N::base,         &F::base},
    {StepKind::fewer,        "fewer",        &N::fewer,        &F::none},
    {StepKind::share,        "share",        &N::share,        &F::share},
    {StepKind::loads,        "loads",        &N::loads,        &F::loads},
    {StepKind::coverage,     "coverage",     &N::coverage,     &F::coverage},
    {StepKind::contacts,     "contacts",     &N::contacts,     &F::contacts},
    {StepKind::cut,          "cut",          &N::cut,          &F::cut},
    {StepKind::slide,        "slide",        &N::slide,        &F::slide},
    {StepKind::closure,      "closure",      &N::closure,      &F::closure},
    {StepKind::second_order, "second_order", &N::second_order, &F::closure},
    {StepKind::result,       "result",       &N::result,       &F::result},
    {StepKind::lever,        "lever",        &N::lever,        &F::lever},
    {StepKind::three,        "three",        &N::three,        &F::three},
    {StepKind::many,         "many",         &N::many,         &F::many},
    {StepKind::rest,         "rest",         &N::rest,         &F::rest},
    {StepKind::mirror,       "mirror",       &N::mirror,       &F::mirror},
    {StepKind::completion,   "completion",   &N::completion,   &F::completion},
    {StepKind::start,        "start",        &N::start,        &F::start},
    {StepKind::exchange,     "exchange",     &N::exchange,     &F::exchange},
    {StepKind::round,        "round",        &N::round,        &F::round},
    {StepKind::settled,      "settled",      &N::settled,      &F::round},
    {StepKind::failure,      "failure",      &N::failure,      &F::failure},
    {StepKind::failures,     "failures",     &N::failures,     &F::round},
    {StepKind::pairs,        "pairs",        &N::pairs,        &F::pairs},
    {StepKind::range,        "range",        &N::range,        &F::range},
    {StepKind::swap,         "swap",         &N::swap,         &F::swap},
    {StepKind::held,         "held",         &N::held,         &F::held},
    {StepKind::stands,       "stands",       &N::stands,       &F::stands},
    {StepKind::support,      "support",      &N::support,      &F::support},
    {StepKind::equations,    "equations",    &N::equations,    &F::equations},
    {StepKind::by_lever,     "by_lever",     &N::each_load,    &F::by_lever},
    {StepKind::by_areas,     "by_areas",     &N::each_load,    &F::by_areas},
    {StepKind::by_springs,   "by_springs",   &N::by_springs,   &F::by_springs},
    {StepKind::extremes,     "extremes",     &N::extremes,     &F::extremes},
    {StepKind::falls,        "falls",        &N::falls,        &F::falls},
    {StepKind::cargo,        "cargo",        &N::cargo,        &F::cargo},
};
// clang-format on

static_assert(has_each_step(steps));

const StepRow& row_of(StepKind kind) { return steps[static_cast<std::size_t>(kind)]; }

constexpr std::string_view figure_names[] = {
    "object",      "triangle",      "centroid",    "centre",
    "vertex",      "radial_edge",   "ray",         "chord",
    "edge",        "section",       "reflected",   "section_end",
    "bisecting",   "chosen",        "candidate",   "team",
    "robot",       "gain_triangle", "gain_part",   "gain_circle",
    "arm_before",  "arm_after",     "base_before", "base",
    "contact",     "normal",        "clockwise",   "counterclockwise",
    "translation", "lever",         "side",        "arm",
    "sum",         "middle",        "stand",       "mirrored",
    "even_chord",  "left",          "way",         "range",
    "range_end",   "former",        "unusable",    "body",
    "hand",        "share",         "level",       "sinks",
    "hole",        "hole_part",     "cargo",       "old_centre"};
static_assert(std::size(figure_names) == figure_kind_count);

}  // namespace

std::string_view name(Chapter chapter) { return chapter_names[static_cast<std::size_t>(chapter)]; }

std::string_view name(StepKind kind) { return row_of(kind).name; }

std::string_view name(FigureKind kind) { return figure_names[static_cast<std::size_t>(kind)]; }

std::optional<StepKind> step_kind_from_name(std::string_view text) {
  const auto* row = std::find_if(std::begin(steps), std::end(steps),
                                 [&](const StepRow& r) { return r.name == text; });
  return row == std::end(steps) ? std::nullopt : std::optional(row->kind);
}

std::vector<Number> numbers(const Trace& trace, const StepDetail& detail) {
  StepNumbers numbers(trace, detail);
  (numbers.*row_of(detail.step.kind).numbers)();
  return std::move(numbers).take();
}

std::vector<Figure> figures(const Trace& trace, const StepDetail& detail) {
  StepFigures figures(trace, detail);
  (figures.*row_of(detail.step.kind).figures)();
  return std::move(figures).take();
}

namespace {

constexpr std::uint32_t teams_shown = 3;  // in addition to the last
constexpr std::uint32_t swaps_shown = 3;
constexpr std::uint32_t supports_shown = 4;
constexpr std::uint32_t cargo_shown = 3;

std::uint32_t telling_pair(const Trace& trace) {
  constexpr std::uint32_t most_looked_at = 200;
  constexpr double as_long = 1 + 1e-6;  // so that congruent shapes choose alike
  const auto pairs = static_cast<std::uint32_t>(trace.pairs.size());
  std::uint32_t telling = 0, looked_at = 0;
  double longest = 0;
  for (std::uint32_t i = 0; i < pairs && looked_at < most_looked_at; ++i) {
    if (trace.candidate_of_source[i] == no_index) continue;
    ++looked_at;
    const PairDetail pair = look_at_pair(trace, i);
    const double sections = length(pair.a[1] - pair.a[0]) + length(pair.b[1] - pair.b[0]);
    if (looked_at > 1 && sections <= longest * as_long) continue;
    telling = i;
    longest = sections;
  }
  return telling;
}

// Swaps that gain the most coverage, in order.
std::vector<std::uint32_t> telling_swaps(const Trace& trace) {
  const BalancedHistory& history = trace.history;
  std::vector<double> gains;
  double before = 0;
  for (std::size_t i = 0; i <= history.moves.size() && history.found; ++i) {
    const auto& robots = i == 0 ? history.start.back().robots : history.moves[i - 1].set.robots;
    const double coverage = balanced_keys(*trace.problem, robots).coverage;
    if (i > 0) gains.push_back(coverage - before);
    before = coverage;
  }
  std::vector<std::uint32_t> order =
      sorted_indices(gains.size(), [&](std::uint32_t i, std::uint32_t j) {
        return gains[i] > gains[j] || (gains[i] == gains[j] && i < j);
      });
  if (order.size() > swaps_shown) order.resize(swaps_shown);
  std::sort(order.begin(), order.end());
  return order;
}

}  // namespace

std::vector<std::uint32_t> main_steps(const Trace& trace) {
  std::vector<std::uint32_t> steps;
  const auto add = [&](StepKind kind, std::uint32_t item) {
    if (const auto step = trace.find(kind, item)) steps.push_back(*step);
  };
  add(StepKind::polygon, 0);
  for (std::uint32_t i = 0; i < std::min(trace.count(StepKind::cargo), cargo_shown); ++i)
    add(StepKind::cargo, i);
  for (const StepKind kind : {StepKind::centre, StepKind::stands, StepKind::ray, StepKind::slopes})
    add(kind, 0);
  const std::uint32_t pair = telling_pair(trace);
  for (const StepKind kind : {StepKind::sections, StepKind::outcome}) add(kind, pair);
  add(StepKind::range, 0);
  if (trace.pairs.empty()) add(StepKind::opposite, 0);
  for (const StepKind kind :
       {StepKind::candidates, StepKind::directions, StepKind::lever, StepKind::three,
        StepKind::many, StepKind::rest, StepKind::mirror, StepKind::completion})
    add(kind, 0);
  if (const std::uint32_t sets = trace.count(StepKind::start)) add(StepKind::start, sets - 1);
  const auto teams = static_cast<std::uint32_t>(trace.placement.teams.size());
  for (std::uint32_t team = 0; team < std::min(teams, teams_shown); ++team) {
    add(StepKind::scores, team);
    add(StepKind::team, team);
  }
  for (const std::uint32_t swap : telling_swaps(trace)) add(StepKind::exchange, swap);
  add(StepKind::settled, 0);
  for (std::uint32_t i = 0; i < std::min(trace.count(StepKind::support), supports_shown); ++i)
    add(StepKind::support, i);
  for (const StepKind kind : {StepKind::equations, StepKind::by_lever, StepKind::by_areas,
                              StepKind::by_springs, StepKind::falls})
    add(kind, 0);
  if (teams > teams_shown) add(StepKind::team, teams - 1);
  if (teams > 0) add(StepKind::base, teams - 1);
  for (std::uint32_t i = 0; i < std::min(trace.count(StepKind::swap), swaps_shown); ++i)
    add(StepKind::swap, i);
  add(StepKind::held, 0);
  for (const StepKind kind :
       {StepKind::fewer, StepKind::loads, StepKind::extremes, StepKind::failures, StepKind::pairs,
        StepKind::coverage, StepKind::contacts, StepKind::closure, StepKind::second_order,
        StepKind::result})
    if (kind != StepKind::contacts || !trace.balanced()) add(kind, 0);
  return steps;
}

std::uint32_t further_like(const Trace& trace, const Step& step) {
  const std::uint32_t all = trace.count(step.kind);
  if (step.kind == StepKind::ray || step.kind == StepKind::outcome) return all - 1;
  if (step.kind == StepKind::team && step.item + 1 == teams_shown && all > teams_shown + 1)
    return all - teams_shown - 1;
  if (step.kind == StepKind::start || step.kind == StepKind::range) return all - 1;
  if (step.kind == StepKind::cargo && step.item + 1 == cargo_shown) return all - cargo_shown;
  if (step.kind == StepKind::swap && step.item + 1 == swaps_shown) return all - swaps_shown;
  if (step.kind == StepKind::exchange && all > swaps_shown &&
      step.item == telling_swaps(trace).back())
    return all - swaps_shown;
  return 0;
}

}  // namespace evenlift
