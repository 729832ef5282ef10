#include <algorithm>
#include <numeric>

#include "evenlift/trace.h"
#include "evenlift/why_not.h"

namespace evenlift {
namespace {

const std::vector<std::uint32_t>& taken_before(const Trace& trace, std::uint32_t swap) {
  return swap == 0 ? trace.swaps->start : trace.swaps->swaps[swap - 1].taken;
}

// With several teams, questions alternate between the team that leaves and the place where it goes.
std::optional<QuestionKind> asked_of_swap(const Trace& trace, std::uint32_t number) {
  const Swap& swap = trace.swaps->swaps[number];
  if (swap.kind != SwapKind::single) return std::nullopt;
  if (swap.taken.size() > 1 && number % 2 == 0) return QuestionKind::leaving_team;
  return QuestionKind::coming_candidate;
}

std::vector<std::uint32_t> all_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

std::vector<LiftingPoint> robots_on(const Trace& trace, const std::vector<std::uint32_t>& taken) {
  std::vector<LiftingPoint> robots;
  for (const std::uint32_t candidate : taken)
    for (const LiftingPoint& end : {trace.placement.candidates[candidate].chord.r1,
                                    trace.placement.candidates[candidate].chord.r2})
      robots.push_back(end);
  return robots;
}

// Candidates to which a team could move.
std::vector<std::uint32_t> open_to(const Trace& trace, std::uint32_t swap, std::uint32_t team) {
  std::vector<std::uint32_t> taken = taken_before(trace, swap);
  const Stands* stands = trace.placement.stands.get();
  std::vector<std::uint32_t> open;
  for (const std::uint32_t candidate : all_numbers(trace.placement.candidates.size())) {
    const auto& before = taken_before(trace, swap);
    if (std::find(before.begin(), before.end(), candidate) != before.end()) continue;
    taken[team] = candidate;
    if (!stands || !stands->any_collide(robots_on(trace, taken))) open.push_back(candidate);
  }
  return open;
}

}  // namespace

bool is_choice(const Trace& trace, std::uint32_t k) {
  const Step step = trace.step(k);
  if (step.kind == StepKind::scores)  // one candidate is no choice
    return trace.placement.candidates.size() > step.item + std::size_t{1};
  if (step.kind == StepKind::completion || step.kind == StepKind::exchange)
    return look_at(trace, k).balanced->chords.size() > 1;
  if (step.kind == StepKind::swap) return asked_of_swap(trace, step.item).has_value();
  if (step.kind != StepKind::outcome) return false;
  const Outcome outcome = look_at_pair(trace, step.item).outcome;
  return outcome == Outcome::nearer_end || outcome == Outcome::too_uneven;
}

std::optional<Question> question(const Trace& trace, const StepDetail& detail) {
  if (!is_choice(trace, detail.number)) return std::nullopt;
  if (detail.pair) return Question{QuestionKind::nearer_end, detail.pair->nearer};
  if (detail.balanced) return Question{QuestionKind::even_chord, detail.balanced->chosen};
  if (detail.scores) return Question{QuestionKind::winning_chord, detail.scores->ranking.front()};
  const QuestionKind kind = *asked_of_swap(trace, detail.step.item);
  const SwapDetail& swap = *detail.swap;
  return Question{kind, kind == QuestionKind::leaving_team ? swap.teams[0] : swap.to[0]};
}

std::vector<std::uint32_t> choices(const Trace& trace, const StepDetail& detail,
                                   const Question& question) {
  switch (question.kind) {
    case QuestionKind::nearer_end:
      return all_numbers(2);
    case QuestionKind::even_chord:
      return all_numbers(detail.balanced->chords.size());
    case QuestionKind::leaving_team:
      return all_numbers(taken_before(trace, detail.step.item).size());
    case QuestionKind::coming_candidate:
      return open_to(trace, detail.step.item, detail.swap->teams[0]);
    case QuestionKind::winning_chord:
      break;
  }
  std::vector<std::uint32_t> candidates = detail.scores->ranking;
  std::sort(candidates.begin(), candidates.end());
  return candidates;
}

const Chord& chord_of_choice(const Trace& trace, const StepDetail& detail, const Question& question,
                             std::uint32_t choice) {
  switch (question.kind) {
    case QuestionKind::nearer_end:
      return detail.pair->ends[choice];
    case QuestionKind::even_chord:
      return detail.balanced->chords[choice];
    case QuestionKind::leaving_team:
      choice = taken_before(trace, detail.step.item)[choice];
      break;
    case QuestionKind::winning_chord:
    case QuestionKind::coming_candidate:
      break;
  }
  return trace.placement.candidates[choice].chord;
}

OtherSwap compare_swap(const Trace& trace, const StepDetail& detail, const Question& question,
                       std::uint32_t choice) {
  const Placement& placement = trace.placement;
  const HoldRequirements hold = hold_requirements(placement);
  const Stands* stands = placement.stands.get();
  std::vector<std::uint32_t> taken = taken_before(trace, detail.step.item);
  OtherSwap other;
  if (question.kind == QuestionKind::leaving_team) {
    other.team = choice;
    const auto best = best_swap_of(trace.object(), trace.centre, placement.candidates, taken,
                                   choice, hold, stands);
    if (!best) return other;
    other.candidate = best->taken[choice];
    other.keys = best->keys;
    return other;
  }
  other.team = detail.swap->teams[0];
  other.candidate = choice;
  taken[other.team] = choice;
  other.keys = hold_keys(trace.object(), trace.centre, placement.candidates, taken, hold, stands);
  return other;
}

}  // namespace evenlift
