#include "trace/step_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "evenlift/placed_robots.h"
#include "evenlift/stability.h"

namespace evenlift {
namespace {

bool same_place(const LiftingPoint& a, const LiftingPoint& b) { return a.position == b.position; }

// Matches each robot to the former one at its place, and the few that moved so that the sum of
// squared distances is least.
std::vector<std::uint32_t> matched(const std::vector<LiftingPoint>& robots,
                                   const std::vector<LiftingPoint>& before) {
  std::vector<std::uint32_t> match(robots.size(), no_index), left;
  std::vector<std::size_t> came;
  std::vector<bool> taken(before.size());
  for (std::size_t i = 0; i < robots.size(); ++i) {
    for (std::uint32_t j = 0; j < before.size() && match[i] == no_index; ++j)
      if (!taken[j] && same_place(robots[i], before[j])) match[i] = j;
    if (match[i] == no_index)
      came.push_back(i);
    else
      taken[match[i]] = true;
  }
  for (std::uint32_t j = 0; j < before.size(); ++j)
    if (!taken[j]) left.push_back(j);
  double least = 0;
  bool any = false;
  do {
    double sum = 0;
    for (std::size_t i = 0; i < came.size(); ++i) {
      const Vec2 way = robots[came[i]].position - before[left[i]].position;
      sum += dot(way, way);
    }
    if (any && !(sum < least)) continue;
    any = true;
    least = sum;
    for (std::size_t i = 0; i < came.size(); ++i) match[came[i]] = left[i];
  } while (std::next_permutation(left.begin(), left.end()));
  return match;
}

const std::vector<LiftingPoint>& robots_before(const Trace& trace, std::size_t move) {
  return move == 0 ? trace.history.start.back().robots : trace.history.moves[move - 1].set.robots;
}

std::vector<std::uint32_t> in_order(std::size_t robots) {
  std::vector<std::uint32_t> numbers(robots);
  for (std::uint32_t i = 0; i < robots; ++i) numbers[i] = i;
  return numbers;
}

// Numbers the last set in order, then goes back to the first.
void number_robots(Trace& trace) {
  const BalancedHistory& history = trace.history;
  trace.robot_numbers.assign(history.moves.size() + 1,
                             in_order(history.start.back().robots.size()));
  for (std::size_t move = history.moves.size(); move-- > 0;) {
    const auto match = matched(history.moves[move].set.robots, robots_before(trace, move));
    for (std::size_t i = 0; i < match.size(); ++i)
      trace.robot_numbers[move][match[i]] = trace.robot_numbers[move + 1][i];
  }
}

const BalancedSet* start_of(const Trace& trace, std::size_t robots) {
  for (const BalancedSet& set : trace.history.start)
    if (set.robots.size() == robots) return &set;
  return nullptr;
}

const BalancedSet* last_set(const Trace& trace) {
  const BalancedHistory& history = trace.history;
  if (!history.found) return nullptr;
  return history.moves.empty() ? &history.start.back() : &history.moves.back().set;
}

// The set whose completion is shown in full: the first of more than two robots, otherwise the last;
// null if all were found at once.
const BalancedSet* shown_completion(const Trace& trace) {
  const BalancedSet* shown = nullptr;
  for (const BalancedSet& set : trace.history.start) {
    if (set.at_once) continue;
    shown = &set;
    if (set.robots.size() > 2) break;
  }
  return shown;
}

const BalancedSet* set_after_round(const Trace& trace, std::uint32_t round) {
  const BalancedSet* set = &trace.history.start.back();
  for (const BalancedMove& move : trace.history.moves)
    if (move.round <= round) set = &move.set;
  return set;
}

// On a large outline the chords found are a sample, which need not contain the chosen one.
Chord chord_taken(const LiftingPoint& r1, const LiftingPoint& r2, const Vec2& middle) {
  return {r1, r2, length(r1.position - middle), length(r2.position - middle), 1};
}

void look_at_completion(const Trace& trace, const BalancedSet& set, BalancedDetail& detail) {
  if (set.at_once) return;
  detail.rest = set.kept;
  if (set.came.size() == 3) {
    detail.stand = set.came[0];
    detail.rest.push_back(set.came[0]);
  }
  Completions possible = completions(*trace.problem, detail.rest);
  detail.middle = possible.middle;
  detail.chords = std::move(possible.chords);
  const LiftingPoint &r1 = set.came[set.came.size() - 2], &r2 = set.came.back();
  const auto taken = std::find_if(
      detail.chords.begin(), detail.chords.end(),
      [&](const Chord& chord) { return same_place(chord.r1, r1) && same_place(chord.r2, r2); });
  detail.chosen = static_cast<std::uint32_t>(taken - detail.chords.begin());
  if (taken == detail.chords.end()) detail.chords.push_back(chord_taken(r1, r2, detail.middle));
}

void look_at_exchange(const Trace& trace, std::size_t move, BalancedDetail& detail) {
  const std::vector<LiftingPoint>& before = robots_before(trace, move);
  detail.keys_before = balanced_keys(*trace.problem, before);
  detail.margin_before = margin_of(trace, before);
  const auto match = matched(detail.robots, before);
  for (std::uint32_t number = 0; number < detail.robots.size(); ++number) {
    for (std::size_t i = 0; i < detail.robots.size(); ++i) {
      const LiftingPoint& from = before[match[i]];
      if (detail.numbers[i] != number || same_place(detail.robots[i], from)) continue;
      detail.moved.push_back(number);
      detail.ways.push_back(from.position);
      detail.ways.push_back(detail.robots[i].position);
    }
  }
}

void look_at_failure(const Trace& trace, StepDetail& detail, BalancedDetail& balanced) {
  balanced.failed = detail.step.item;
  const auto failed = static_cast<std::ptrdiff_t>(detail.step.item);
  detail.base_before = lifting_base(trace.polygon(), balanced.robots);
  balanced.robots.erase(balanced.robots.begin() + failed);
  balanced.numbers.erase(balanced.numbers.begin() + failed);
  if (auto springs = spring_loads(positions(balanced.robots), trace.centre,
                                  trace.polygon().diameter(), trace.placement.weight()))
    balanced.loads = std::move(springs->loads);
}

void look_at_failures(const Trace& trace, StepDetail& detail, BalancedDetail& balanced) {
  if (detail.step.kind == StepKind::failure) look_at_failure(trace, detail, balanced);
  if (detail.step.kind != StepKind::pairs) return;
  detail.base_before = lifting_base(trace.polygon(), balanced.robots);
  balanced.robots = lifting_points(trace.in_pairs->teams);
  balanced.numbers.clear();
  for (std::uint32_t i = 0; i < balanced.robots.size(); ++i) balanced.numbers.push_back(i / 2);
}

std::optional<Placement> place_in_pairs(const Trace& trace) {
  Settings settings = trace.placement.settings;
  if (settings.robots % 2 != 0) return std::nullopt;
  settings.method = Method::area;
  settings.teams = settings.robots / 2;
  settings.goal.reset();
  Result<Placement> pairs = place(trace.object(), trace.placement.own_centre, settings);
  if (!pairs || pairs->teams.size() < *settings.teams) return std::nullopt;
  return *std::move(pairs);
}

std::vector<std::uint32_t> numbers_of(const Trace& trace, const BalancedSet& set) {
  const BalancedHistory& history = trace.history;
  if (history.found && &set == &history.start.back()) return trace.robot_numbers.front();
  for (std::size_t move = 0; move < history.moves.size(); ++move)
    if (&set == &history.moves[move].set) return trace.robot_numbers[move + 1];
  return in_order(set.robots.size());
}

bool completes(StepKind kind) {
  return kind == StepKind::rest || kind == StepKind::mirror || kind == StepKind::completion ||
         kind == StepKind::start || kind == StepKind::exchange;
}

bool has_base(const Step& step) {
  return step.kind == StepKind::completion || step.kind == StepKind::start ||
         step.chapter > Chapter::start;
}

}  // namespace

std::optional<InputError> trace_search(Trace& trace, HistoryLength length) {
  Placement& placement = trace.placement;
  trace.problem.emplace(trace.object(), trace.centre, placement.settings);
  if (length == HistoryLength::whole && !is_quick_to_finish(*trace.problem))
    return InputError{
        ErrorCode::unsupported,
        "the search for this number of robots on this outline is too long to show step by step; "
        "ask for fewer robots"};
  if (length == HistoryLength::start && !is_quick_to_start(*trace.problem)) return std::nullopt;
  trace.history = balanced_history(*trace.problem, length);
  if (trace.history.found) {
    number_robots(trace);
    const std::vector<LiftingPoint> robots = last_set(trace)->robots;
    placement = with_robots(std::move(placement), robots, length == HistoryLength::whole);
    if (length == HistoryLength::whole) trace.in_pairs = place_in_pairs(trace);
    if (trace.in_pairs) trace.report_of_pairs = report_of(*trace.in_pairs);
  }
  return std::nullopt;
}

const BalancedSet* balanced_set_at(const Trace& trace, const Step& step) {
  switch (step.kind) {
    case StepKind::lever:
      return start_of(trace, 2);
    case StepKind::three:
      return start_of(trace, 3);
    case StepKind::rest:
    case StepKind::mirror:
    case StepKind::completion:
      return shown_completion(trace);
    case StepKind::start:
      return &trace.history.start[step.item];
    case StepKind::exchange:
      return &trace.history.moves[step.item].set;
    case StepKind::round:
      return set_after_round(trace, step.item);
    default:
      return step.chapter == Chapter::object ? nullptr : last_set(trace);
  }
}

void look_at_balanced(const Trace& trace, StepDetail& detail) {
  const Step& step = detail.step;
  const BalancedSet* set = balanced_set_at(trace, step);
  if (!set) return;
  BalancedDetail balanced;
  balanced.robots = set->robots;
  if (step.chapter != Chapter::law || step.kind == StepKind::many)
    balanced.numbers = numbers_of(trace, *set);
  else
    balanced.numbers = in_order(set->robots.size());
  balanced.keys = balanced_keys(*trace.problem, set->robots);
  balanced.margin = margin_of(trace, set->robots);
  if (completes(step.kind)) look_at_completion(trace, *set, balanced);
  if (step.kind == StepKind::exchange) {
    look_at_exchange(trace, step.item, balanced);
    detail.base_before = lifting_base(trace.polygon(), robots_before(trace, step.item));
  }
  if (step.kind == StepKind::start) detail.base_before = lifting_base(trace.polygon(), set->kept);
  if (step.chapter == Chapter::failures) look_at_failures(trace, detail, balanced);
  if (has_base(step))
    detail.base = lifting_base(trace.polygon(),
                               step.chapter == Chapter::failures ? balanced.robots : set->robots);
  // Here the set lacks the two robots that complete it.
  if (step.kind == StepKind::rest || step.kind == StepKind::mirror) {
    balanced.robots = balanced.rest;
    balanced.numbers = in_order(balanced.robots.size());
  }
  detail.balanced = std::move(balanced);
}

}  // namespace evenlift
