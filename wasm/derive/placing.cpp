#include "derive/placing.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "state/method.h"
#include "state/opened.h"

namespace evenlift::view {
namespace {

// The candidates of any load ratio.
Result<std::vector<Candidate>> all_candidates(const Placement& placement) {
  const Polygon& polygon = placement.polygon();
  if (!placement.stands) return find_candidates(polygon, placement.centre_of_mass, 0);
  auto found = standing_candidates(polygon, placement.centre_of_mass, 0, *placement.stands);
  if (!found) return found.error();
  return std::move(found->candidates);
}

// The number of balanced robots to compare with the placement.
std::uint32_t robots_beside(const Derived& facts, std::uint32_t teams) {
  return facts.placed.settings.method == Method::given
             ? static_cast<std::uint32_t>(facts.placed.settings.supports.size())
             : 2 * teams;
}

}  // namespace

Document by_other_method(const Derived& facts, Method method) {
  Document document = facts.placed;
  document.moved = {};
  const std::uint32_t teams = placed_teams(facts.placement);
  Settings& settings = document.settings;
  if (!settings.teams || is_one_team(settings.method)) settings.teams = teams;
  if (method == Method::balanced)
    settings.robots = std::clamp(robots_beside(facts, teams), fewest_robots(settings), most_robots);
  settings = with_method(settings, method, teams);
  return document;
}

std::optional<double> best_ratio_if_none(const Placement& placement) {
  if (!placement.teams.empty() || !selects_candidates(placement.settings.method))
    return std::nullopt;
  const auto any = all_candidates(placement);
  if (!any || any->empty()) return std::nullopt;
  double best = 0;
  for (const Candidate& c : *any) best = std::max(best, c.chord.ratio);
  // To two decimals, like the slider's values.
  return std::floor(best * 100) / 100;
}

void renew_second(Derived& facts, const Work& work, Haste haste) {
  facts.second.reset();
  if (!work.second_method) return;
  const Document document = by_other_method(facts, *work.second_method);
  if (Result<Placement> placement = compute_placement(document, facts.placement, haste))
    facts.second = std::move(placement).value();
}

void adopt(Derived& facts, const Document& document, Result<Placement> placement) {
  if (!placement) {
    facts.refusal = placement.error();
    return;
  }
  facts.plan_due |= !facts.placement || !same_plan(*facts.placement, *placement);
  facts.placement = std::move(placement).value();
  facts.placed = document;
  facts.refusal.reset();
}

}  // namespace evenlift::view
