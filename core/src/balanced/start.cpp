#include "balanced/start.h"

#include "balanced/rounds.h"
#include "balanced/usable_sets.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace evenlift::balanced {
namespace {

std::uint64_t most_steps_of_start(const Rules& rules) {
  return rules.is_large() ? most_start_steps_if_large : most_start_steps;
}

// The trial points from which S_4 begins.
enum class Begin { as_usual, at_every_stand };

std::optional<StartSet> next_set(const Rules& rules, const StartSets& sets, Begin begin,
                                 std::uint64_t& steps) {
  const std::size_t number = sets.size();
  const std::uint64_t most = most_steps_of_start(rules);
  Best best(rules, most - std::min(most, steps));
  if (sets[number - 2]) best.offer_two_more(sets[number - 2]->set.robots);
  if (number >= 3 && sets[number - 3]) best.offer_three_more(sets[number - 3]->set.robots);
  const bool at_stands = rules.robots() == 4 || begin == Begin::at_every_stand;
  if (number == 4 && (at_stands || !best.set()))
    for (const LiftingPoint& stand : rules.stands()) best.offer_three_more({stand});
  steps += best.steps();
  if (!best.set()) return std::nullopt;
  const std::vector<LiftingPoint>& robots = best.set()->robots;
  const auto kept = robots.begin() + static_cast<std::ptrdiff_t>(best.kept());
  return StartSet{rules.in_order(*best.set()), {robots.begin(), kept}, {kept, robots.end()}};
}

StartSets chain(const Rules& rules, Begin begin, std::uint64_t& steps) {
  StartSets sets{StartSet{}, std::nullopt};
  while (sets.size() <= rules.robots()) sets.push_back(next_set(rules, sets, begin, steps));
  return sets;
}

// The result of the swaps from a start, whose steps add to `work`.
RatedSet end_of(const Rules& rules, const RatedSet& start, BalancedWork& work) {
  BalancedSearch search;
  search.robots = rules.in_order(start).robots;
  search.finished = rules.robots() < 3;
  search.restarted = true;
  search.work.steps = work.steps;
  const BalancedSearch end = finish_search(rules, std::move(search));
  work.steps = end.work.steps;
  return rules.rated(end.robots);
}

StartSet whole(const Rules& rules, const RatedSet& set) {
  const RatedSet ordered = rules.in_order(set);
  return {ordered, {}, ordered.robots, true};
}

std::optional<StartSets> start_that_leads_farther(const Rules& rules, RatedSet now,
                                                  BalancedWork& work) {
  std::optional<StartSets> start;
  for (const RatedSet& set : usable_sets(rules, most_starts)) {
    RatedSet end = end_of(rules, set, work);
    if (!rules.better(end, now)) continue;
    now = std::move(end);
    start = StartSets{whole(rules, set)};
  }
  return start;
}

}  // namespace

StartSets start_sets(const Rules& rules, bool* cut_short) {
  std::uint64_t steps = 0;
  StartSets sets = chain(rules, Begin::as_usual, steps);
  if (cut_short) *cut_short = steps >= most_steps_of_start(rules);
  if (rules.room() && !sets.back())
    for (const RatedSet& set : usable_sets(rules, 1)) sets.back() = whole(rules, set);
  return sets;
}

std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& robots,
                                      BalancedWork& work) {
  RatedSet now = rules.rated(robots);
  if (rules.room()) return start_that_leads_farther(rules, std::move(now), work);
  if (rules.robots() <= 4 || !rules.misses_hold(now)) return std::nullopt;
  std::uint64_t steps = 0;
  StartSets sets = chain(rules, Begin::at_every_stand, steps);
  work.steps += steps;
  if (!sets.back() || !rules.holds_better(sets.back()->set, now)) return std::nullopt;
  return sets;
}

}  // namespace evenlift::balanced
