#include "evenlift/balanced.h"

#include <cstddef>
#include <utility>

#include "balanced/completions.h"
#include "balanced/rounds.h"
#include "balanced/start.h"
#include "balanced/triples.h"
#include "evenlift/balanced_history.h"

namespace evenlift {
namespace {

using balanced::Best;
using balanced::RatedSet;
using balanced::Rules;

std::size_t completions_of_start(const Rules& rules) {
  const std::size_t stands = rules.stands().size(), robots = rules.robots();
  return stands * (robots - 1) + (robots == 4 ? stands * stands : 0);
}

// A step takes about a microsecond. A candidate costs one step, and more on a winding outline,
// since the coverage of its set is summed along it.
std::size_t steps_of_completion(const Rules& rules) {
  constexpr std::size_t most_candidates = 2'000, winding = 50;
  const std::size_t candidates = rules.chords().count_about(rules.centre(), most_candidates);
  return candidates * (1 + candidates / winding);
}

BalancedSearch restarted(const Rules& rules, BalancedSearch search) {
  search.restarted = true;
  search.work_before_restart = search.work;
  const auto second = balanced::second_start(rules, search.robots, search.work);
  const bool spent = rules.used(search.work) >= 1;
  search.cut_short |= spent;
  if (!second || spent) return search;
  search.robots = second->back()->set.robots;
  search.round = 0;
  search.finished = rules.robots() < 3;
  return search;
}

BalancedSearch ended(const Rules& rules, BalancedSearch search, std::uint64_t steps) {
  search.work.steps += steps;
  search.work.completions += rules.stands().size() * rules.work_of_completion();
  search.finished = rules.used(search.work) >= 1;
  search.cut_short |= search.finished;
  if (search.finished || search.next < rules.triples().size()) return search;
  ++search.round;
  search.finished = !search.changed || search.round == most_rounds;
  search.next = 0;
  search.changed = false;
  if (!search.finished || search.restarted) return search;
  return restarted(rules, std::move(search));
}

}  // namespace

BalancedProblem::BalancedProblem(PolygonWithHoles object, const Vec2& centre,
                                 const Settings& settings)
    : rules_(std::make_shared<const Rules>(std::move(object), centre, settings)) {}

BalancedKeys balanced_keys(const BalancedProblem& problem,
                           const std::vector<LiftingPoint>& robots) {
  RatedSet set = problem.rules().rated(robots);
  return problem.rules().keys(set);
}

bool is_better(const BalancedProblem& problem, const std::vector<LiftingPoint>& a,
               const std::vector<LiftingPoint>& b) {
  const Rules& rules = problem.rules();
  RatedSet first = rules.rated(a), second = rules.rated(b);
  return rules.better(first, second);
}

std::optional<BalancedSearch> start_balanced(const BalancedProblem& problem, bool* cut_short) {
  const Rules& rules = problem.rules();
  BalancedSearch search;
  auto sets = balanced::start_sets(rules, &search.cut_short);
  if (cut_short) *cut_short = search.cut_short;
  if (!sets.back()) return std::nullopt;
  search.robots = std::move(sets.back()->set.robots);
  search.finished = rules.robots() < 3;
  return search;
}

double work_used(const BalancedProblem& problem, const BalancedSearch& search) {
  return problem.rules().used(search.work);
}

bool is_quick_to_start(const BalancedProblem& problem) {
  return completions_of_start(problem.rules()) * steps_of_completion(problem.rules()) <= 100'000;
}

bool is_quick_to_finish(const BalancedProblem& problem) {
  const Rules& rules = problem.rules();
  constexpr std::size_t usual_rounds = 3;
  // Robots with a size, or with no-go parts, restart from several starts.
  const std::size_t searches = rules.room() ? 2 + balanced::most_starts : 1;
  const std::size_t completions = completions_of_start(rules) + searches * usual_rounds *
                                                                    rules.triples().size() *
                                                                    rules.stands().size();
  return completions * steps_of_completion(rules) <= 500'000;
}

namespace balanced {

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search) {
  if (search.finished) return {std::move(search), std::nullopt};
  const std::vector<Triple>& triples = rules.triples();
  const Triple& triple = triples[search.next++];
  Best best(rules);
  best.offer(rules.rated(search.robots));
  best.offer_three_more(others(search.robots, triple));
  std::optional<BalancedSwap> swap;
  if (best.completed()) {
    swap.emplace();
    swap->numbers = triple;
    // The three new robots are the last.
    const std::vector<LiftingPoint>& robots = best.set()->robots;
    for (std::size_t i = 0; i < triple.size(); ++i) {
      swap->from[i] = search.robots[triple[i]];
      swap->to[i] = robots[robots.size() - triple.size() + i];
    }
    search.robots = rules.in_order(*best.set()).robots;
    search.changed = true;
  }
  return {ended(rules, std::move(search), best.steps()), swap};
}

BalancedSearch finish_search(const Rules& rules, BalancedSearch search) {
  while (!search.finished) search = try_next_triple(rules, std::move(search)).search;
  return search;
}

}  // namespace balanced

BalancedStep try_next_triple(const BalancedProblem& problem, BalancedSearch search) {
  return balanced::try_next_triple(problem.rules(), std::move(search));
}

BalancedSearch finish_search(const BalancedProblem& problem, BalancedSearch search) {
  return balanced::finish_search(problem.rules(), std::move(search));
}

}  // namespace evenlift
