#include "evenlift/capacity.h"

#include <algorithm>
#include <cmath>

#include "evenlift/placement.h"

namespace evenlift {
namespace {

// No fewer can do: with all robots even, each carries weight / (2 teams).
std::uint32_t fewest_teams(double weight, double capacity) {
  const double fewest = std::ceil(weight / (2 * capacity));
  return static_cast<std::uint32_t>(
      std::clamp(fewest, 1.0, static_cast<double>(most_teams_for_capacity)));
}

// The greater half of a team's load, as a share of it. Loads of a placement of any number of teams
// differ in the team's part only.
double greater_share(const Team& team) {
  const Chord& chord = team.chord;
  return std::max(chord.arm1, chord.arm2) / (chord.arm1 + chord.arm2);
}

// The teams of k are the first k of more.
CapacityPlan plan_prefixes(const Placement& most, double weight, double capacity) {
  CapacityPlan plan;
  plan.tried = static_cast<std::uint32_t>(most.teams.size());
  double share = 0.5;
  for (std::uint32_t k = 1; k <= plan.tried; ++k) {
    share = std::max(share, greater_share(most.teams[k - 1]));
    const double greatest = weight / k * share;
    if (greatest <= capacity) return {true, k, greatest, k};
  }
  return plan;
}

Result<CapacityPlan> plan_one_by_one(Document document, double capacity) {
  CapacityPlan plan;
  for (std::uint32_t k = fewest_teams(document.settings.weight, capacity);
       k <= most_teams_for_capacity; ++k) {
    document.settings.teams = k;
    const Result<Placement> placement = place(document);
    if (!placement) return placement.error();
    if (placement->teams.size() < k) break;
    plan.tried = k;
    if (placement->loads->max <= capacity) return CapacityPlan{true, k, placement->loads->max, k};
  }
  return plan;
}

}  // namespace

Result<CapacityPlan> plan_capacity(const Document& document, double capacity) {
  const Metric metric = document.settings.metric;
  if (metric == Metric::distributed || metric == Metric::random)
    return plan_one_by_one(document, capacity);
  Document most = document;
  // The least even team that may be taken decides how many are enough, if there are so many.
  const double enough =
      std::ceil(document.settings.weight / (capacity * (1 + document.settings.min_ratio)));
  most.settings.teams = static_cast<std::uint32_t>(
      std::clamp(enough + 1, 1.0, static_cast<double>(most_teams_for_capacity)));
  const Result<Placement> placement = place(most);
  if (!placement) return placement.error();
  return plan_prefixes(*placement, document.settings.weight, capacity);
}

}  // namespace evenlift
