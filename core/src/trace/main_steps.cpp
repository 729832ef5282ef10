#include "evenlift/main_steps.h"

#include <algorithm>

namespace evenlift {
namespace {

constexpr std::uint32_t teams_shown = 3;  // besides the last

// The pair that stands for all.
std::uint32_t telling_pair(const Trace& trace) {
  const auto pairs = static_cast<std::uint32_t>(trace.pairs.size());
  for (std::uint32_t i = 0; i < pairs; ++i)
    if (trace.candidate_of_source[i] != no_index) return i;
  return 0;
}

}  // namespace

std::vector<std::uint32_t> main_steps(const Trace& trace) {
  std::vector<std::uint32_t> steps;
  const auto add = [&](StepKind kind, std::uint32_t item) {
    if (const auto step = trace.find(kind, item)) steps.push_back(*step);
  };
  for (const StepKind kind : {StepKind::polygon, StepKind::centre, StepKind::ray, StepKind::slopes})
    add(kind, 0);
  const std::uint32_t pair = telling_pair(trace);
  for (const StepKind kind : {StepKind::sections, StepKind::outcome}) add(kind, pair);
  if (trace.pairs.empty()) add(StepKind::opposite, 0);
  add(StepKind::candidates, 0);
  add(StepKind::directions, 0);
  const auto teams = static_cast<std::uint32_t>(trace.placement.teams.size());
  for (std::uint32_t team = 0; team < std::min(teams, teams_shown); ++team) {
    add(StepKind::scores, team);
    add(StepKind::team, team);
  }
  if (teams > teams_shown) add(StepKind::team, teams - 1);
  if (teams > 0) add(StepKind::base, teams - 1);
  for (const StepKind kind :
       {StepKind::fewer, StepKind::loads, StepKind::coverage, StepKind::contacts, StepKind::closure,
        StepKind::second_order, StepKind::result})
    add(kind, 0);
  return steps;
}

std::uint32_t further_like(const Trace& trace, const Step& step) {
  const std::uint32_t all = trace.count(step.kind);
  if (step.kind == StepKind::ray || step.kind == StepKind::outcome) return all - 1;
  if (step.kind == StepKind::team && step.item + 1 == teams_shown && all > teams_shown + 1)
    return all - teams_shown - 1;
  return 0;
}

}  // namespace evenlift
