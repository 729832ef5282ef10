#include "derive/outlook.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace evenlift::view {
namespace {

double greatest_of(const std::vector<LoadRange>& loads) {
  double greatest = 0;
  for (const LoadRange& range : loads) greatest = std::max(greatest, range.greatest);
  return greatest;
}

Outlook outlook_of(const Placement& placement, LoadModel model, const Shown& shown) {
  const Disturbance disturbance = disturbance_of(shown);
  Outlook outlook;
  outlook.robustness = robustness(placement);
  if (model != LoadModel::plan || disturbance.any())
    outlook.models = model_loads(placement, disturbance);
  if (outlook.models) outlook.model = model;
  outlook.loads = shown_loads({placement, shown}, model, outlook.models);
  outlook.greatest = greatest_of(outlook.loads);
  outlook.extra = extra_load({placement, shown});
  return outlook;
}

// The others share the weight by springs, whichever model is shown.
Outlook outlook_of(const Placement& placement, const Failure& failure, const Shown& shown) {
  Outlook outlook;
  outlook.model = LoadModel::springs;
  outlook.robustness.tipping_distance = failure.rest ? failure.rest->tipping_distance : 0;
  const Disturbance disturbance = disturbance_of(shown);
  const bool stays = failure.rest && failure.rest->stays;
  const auto ranges = disturbance.any() && stays
                          ? ranges_without(placement, failure.robot, disturbance)
                          : std::nullopt;
  outlook.loads = ranges ? *ranges : loads_by(LoadModel::plan, failure.placement, std::nullopt);
  outlook.greatest = greatest_of(outlook.loads);
  return outlook;
}

// A millisecond or two at most, for each frame of a drag.
bool is_quick(const Placement& placement) {
  return count_robots(placement.teams) <= 16 && placement.vertices().size() <= 2000;
}

}  // namespace

void renew_outlooks(Derived& facts, LoadModel model, const Shown& shown) {
  if (!facts.placement) return;
  facts.outlook = outlook_of(*facts.placement, model, shown);
  facts.second_outlook = facts.second ? outlook_of(*facts.second, model, shown) : Outlook{};
  if (facts.failure) facts.failure->outlook = outlook_of(*facts.placement, *facts.failure, shown);
}

void renew_failures(Derived& facts, const Shown& shown, bool move) {
  if (!facts.failures_due || !facts.placement || facts.refusal) return;
  const Placement& placement = *facts.placement;
  if (move && !is_quick(placement)) return;
  facts.failures_due = false;
  facts.failures.clear();
  if (count_robots(placement.teams) <= most_failures_known)
    facts.failures = single_failures(placement, disturbance_of(shown));
}

void let_fail(Derived& facts, std::size_t robot, const Shown& shown) {
  facts.failure.reset();
  const Placement& placement = *facts.placement;
  if (robot >= count_robots(placement.teams)) return;
  const bool known = robot < facts.failures.size();
  Failure failure{
      robot,
      known ? facts.failures[robot] : single_failure(placement, robot, disturbance_of(shown)),
      with_failure(placement, robot),
      {}};
  failure.outlook = outlook_of(placement, failure, shown);
  facts.failure = std::move(failure);
}

}  // namespace evenlift::view
