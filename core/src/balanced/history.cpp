#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "balanced/search.h"
#include "evenlift/balanced.h"
#include "evenlift/balanced_history.h"

namespace evenlift {
namespace {

double square(const LiftingPoint& a, const LiftingPoint& b) {
  return squared_length(a.position - b.position);
}

}  // namespace

std::optional<std::vector<LiftingPoint>> move_robot(const BalancedProblem& problem,
                                                    std::vector<LiftingPoint> robots,
                                                    std::size_t moved, const LiftingPoint& to) {
  const std::size_t m = robots.size();
  if (m < 3 || moved >= m) return std::nullopt;
  const Stands* room = problem.rules().room();
  if (room && !room->can_lift(room->lifting_point(to))) return std::nullopt;
  const std::array<std::size_t, 2> followers{(moved + m - 1) % m, (moved + 1) % m};
  robots[moved] = room ? room->lifting_point(to) : to;
  std::vector<LiftingPoint> others;
  for (std::size_t i = 0; i < m; ++i)
    if (i != followers[0] && i != followers[1]) others.push_back(robots[i]);

  // Either end of the chord may go to either follower.
  std::optional<std::array<LiftingPoint, 2>> nearest;
  double least = 0;
  for (const Candidate& candidate : balanced::all_pairs_to_complete(problem.rules(), others)) {
    const LiftingPoint &r1 = candidate.chord.r1, &r2 = candidate.chord.r2;
    for (const std::array<LiftingPoint, 2>& ends : {std::array{r1, r2}, std::array{r2, r1}}) {
      const double way =
          square(ends[0], robots[followers[0]]) + square(ends[1], robots[followers[1]]);
      if (nearest && !(way < least)) continue;
      if (problem.rules().collides(others, others.size(), r1) ||
          problem.rules().collides(others, others.size(), r2))
        continue;
      nearest = ends;
      least = way;
    }
  }
  if (!nearest || (room && room->any_collide(others))) return std::nullopt;
  for (std::size_t i = 0; i < followers.size(); ++i) robots[followers[i]] = (*nearest)[i];
  return robots;
}

namespace {

using balanced::Best;
using balanced::RatedSet;
using balanced::Rules;

std::optional<BalancedKey> decided(const Rules& rules, const std::vector<LiftingPoint>& a,
                                   const std::vector<LiftingPoint>& b) {
  RatedSet first = rules.rated(a), second = rules.rated(b);
  return rules.decided_by(first, second);
}

void note_start(balanced::StartSets sets, BalancedHistory& history) {
  history.start.clear();
  history.moves.clear();
  for (auto& set : sets)
    if (set && !set->set.robots.empty())
      history.start.push_back(
          {std::move(set->set.robots), std::move(set->kept), std::move(set->came), set->at_once});
}

// The robots just before the search restarts.
std::vector<LiftingPoint> last_before(const BalancedStep& step,
                                      const std::vector<LiftingPoint>& before) {
  if (!step.swap) return before;
  std::vector<LiftingPoint> robots = balanced::others(before, step.swap->numbers);
  robots.insert(robots.end(), step.swap->to.begin(), step.swap->to.end());
  return robots;
}

BalancedMove move_of(const Rules& rules, const BalancedStep& step,
                     const std::vector<LiftingPoint>& before, std::uint32_t round) {
  BalancedMove move;
  move.set = {step.search.robots,
              balanced::others(before, step.swap->numbers),
              {step.swap->to.begin(), step.swap->to.end()}};
  move.numbers = step.swap->numbers;
  move.round = round;
  move.decided_by = decided(rules, step.search.robots, before).value_or(BalancedKey::places);
  return move;
}

// Continues from the start and notes each swap and round. After a restart, the history begins with
// the second start, since the first one led nowhere.
void follow(const BalancedProblem& problem, BalancedHistory& history) {
  BalancedSearch search;
  search.robots = history.start.back().robots;
  search.finished = search.robots.size() < 3;
  while (!search.finished) {
    const std::vector<LiftingPoint> before = search.robots;
    const std::uint32_t round = search.round;
    const bool may_restart = !search.restarted;
    const BalancedStep step = try_next_triple(problem, std::move(search));
    search = step.search;
    history.rounds = search.round;
    const Rules& rules = problem.rules();
    const bool restarts = may_restart && search.restarted && !search.finished;
    if (step.swap && !restarts) history.moves.push_back(move_of(rules, step, before, round));
    if (!restarts) continue;
    BalancedWork work = search.work_before_restart;
    note_start(*balanced::second_start(rules, last_before(step, before), work), history);
  }
  history.settled = !search.cut_short &&
                    (history.moves.empty() || history.moves.back().round + 1 < history.rounds);
}

}  // namespace

std::optional<BalancedKey> decided_by(const BalancedProblem& problem,
                                      const std::vector<LiftingPoint>& a,
                                      const std::vector<LiftingPoint>& b) {
  return decided(problem.rules(), a, b);
}

BalancedHistory balanced_history(const BalancedProblem& problem, HistoryLength length) {
  const Rules& rules = problem.rules();
  auto sets = balanced::start_sets(rules);
  BalancedHistory history;
  history.triples = static_cast<std::uint32_t>(rules.triples().size());
  history.stands = rules.stands().size();
  history.found = sets.back().has_value();
  note_start(std::move(sets), history);
  if (history.found && length == HistoryLength::whole) follow(problem, history);
  return history;
}

Completions completions(const BalancedProblem& problem, const std::vector<LiftingPoint>& robots) {
  const Rules& rules = problem.rules();
  Completions result;
  result.middle = balanced::middle_of_two_more(robots, rules.centre());
  std::uint64_t steps = 0;
  for (const Candidate& candidate : balanced::pairs_to_complete(rules, robots, steps))
    result.chords.push_back(candidate.chord);
  return result;
}

std::optional<BalancedMove> best_with_robot_at(const BalancedProblem& problem,
                                               const std::vector<LiftingPoint>& robots,
                                               const LiftingPoint& place) {
  const Rules& rules = problem.rules();
  std::optional<RatedSet> best;
  BalancedMove move;
  for (const balanced::Triple& triple :
       balanced::triples_of(static_cast<std::uint32_t>(robots.size()))) {
    Best of_triple(rules);
    const std::vector<LiftingPoint> rest = balanced::others(robots, triple);
    of_triple.offer_three_more(rest, place);
    if (!of_triple.set()) continue;
    RatedSet set = *of_triple.set();
    if (best && !rules.better(set, *best)) continue;
    move.set.robots = rules.in_order(set).robots;
    move.set.kept = rest;
    move.set.came.assign(set.robots.end() - 3, set.robots.end());
    move.numbers = triple;
    best = std::move(set);
  }
  if (!best) return std::nullopt;
  move.decided_by = decided(rules, move.set.robots, robots).value_or(BalancedKey::places);
  return move;
}

}  // namespace evenlift
