#include "balanced/start.h"

#include <cstddef>
#include <utility>

namespace evenlift::balanced {
namespace {

using Sets = std::vector<std::optional<StartSet>>;

std::optional<StartSet> next_set(const Rules& rules, const Sets& sets) {
  const std::size_t number = sets.size();
  Best best(rules);
  if (sets[number - 2]) best.offer_two_more(sets[number - 2]->set.robots);
  if (number >= 3 && sets[number - 3]) best.offer_three_more(sets[number - 3]->set.robots);
  if (number == 4 && (rules.robots() == 4 || !best.set()))
    for (const LiftingPoint& stand : rules.stands()) best.offer_three_more({stand});
  if (!best.set()) return std::nullopt;
  const std::vector<LiftingPoint>& robots = best.set()->robots;
  const auto kept = robots.begin() + static_cast<std::ptrdiff_t>(best.kept());
  return StartSet{rules.in_order(*best.set()), {robots.begin(), kept}, {kept, robots.end()}};
}

}  // namespace

std::vector<std::optional<StartSet>> start_sets(const Rules& rules) {
  Sets sets{StartSet{}, std::nullopt};
  while (sets.size() <= rules.robots()) sets.push_back(next_set(rules, sets));
  return sets;
}

}  // namespace evenlift::balanced
