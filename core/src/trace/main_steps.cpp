#include "evenlift/main_steps.h"

#include <algorithm>

#include "exact/sorted_indices.h"

namespace evenlift {
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
