#include "edits/outlook.h"

#include <algorithm>
#include <string>

#include "evenlift/settings.h"
#include "state/browser.h"

namespace evenlift::view {
namespace {

double greatest_of(const std::vector<LoadRange>& loads) {
  double greatest = 0;
  for (const LoadRange& range : loads) greatest = std::max(greatest, range.greatest);
  return greatest;
}

Outlook outlook_of(const AppState& state, const Placement& placement) {
  Outlook outlook;
  outlook.robustness = robustness(placement);
  const double radius = shown(state).com_radius;
  const LoadModel model = state.load_model;
  if (model != LoadModel::plan || radius > 0) outlook.models = model_loads(placement);
  if (outlook.models) outlook.model = model;
  outlook.loads = loads_by(model, placement, outlook.models, radius);
  outlook.greatest = greatest_of(outlook.loads);
  return outlook;
}

// The others share the weight by springs, whichever model is shown.
Outlook outlook_of(const AppState& state, const Failure& failure) {
  Outlook outlook;
  outlook.model = LoadModel::springs;
  outlook.robustness.tipping_distance = failure.rest ? failure.rest->tipping_distance : 0;
  const double radius = shown(state).com_radius;
  const auto springs = radius > 0 ? springs_without(*state.placement, failure.robot) : std::nullopt;
  const std::vector<double> loads = planned_loads(failure.placement.teams);
  if (springs)
    outlook.loads = load_ranges(loads, *springs, radius);
  else
    outlook.loads = loads_by(LoadModel::plan, failure.placement, std::nullopt, 0);
  outlook.greatest = greatest_of(outlook.loads);
  return outlook;
}

// Whether it takes a millisecond or two at most, so that it can be done in each picture of a drag.
bool is_quick(const Placement& placement) {
  return count_robots(placement.teams) <= 16 && placement.vertices().size() <= 2000;
}

}  // namespace

void renew_outlook(AppState& state) {
  if (!state.placement) return;
  state.outlook = outlook_of(state, *state.placement);
  state.second_outlook = state.second ? outlook_of(state, *state.second) : Outlook{};
  if (state.failure) state.failure->outlook = outlook_of(state, *state.failure);
}

void forget_failures(AppState& state) {
  state.failure.reset();
  state.failures.clear();
  state.failures_due = true;
}

void renew_failures(AppState& state) {
  if (!state.failures_due || !state.placement || state.refusal) return;
  const Placement& placement = *state.placement;
  const bool moving =
      state.edit_open || state.search.under_way || state.held.kind == Pick::Kind::robot;  // by hand
  if (moving && !is_quick(placement)) return;
  state.failures_due = false;
  state.failures.clear();
  if (count_robots(placement.teams) <= most_failures_known)
    state.failures = single_failures(placement);
}

void let_fail(AppState& state, std::optional<std::size_t> robot) {
  if (!state.placement || state.refusal) return;
  if (robot ? state.failure && state.failure->robot == *robot : !state.failure) return;
  const Placement& placement = *state.placement;
  if (robot && *robot >= count_robots(placement.teams)) return;
  if (robot) {
    const bool known = *robot < state.failures.size();
    state.failure = Failure{*robot,
                            known ? state.failures[*robot] : single_failure(placement, *robot),
                            with_failure(placement, *robot),
                            {}};
    state.failure->outlook = outlook_of(state, *state.failure);
  } else {
    browser::announce("Robot " + std::to_string(state.failure->robot + 1) + " works again.");
    state.failure.reset();
  }
  ++state.revision;
  browser::summary_changed();
}

std::optional<InputError> check_robot(const Placement& placement, std::uint64_t number) {
  const std::size_t count = count_robots(placement.teams);
  if (number <= count) return std::nullopt;
  InputError error = setting_error(Setting::failed);
  error.message = "there is no robot " + std::to_string(number) + ": there are " +
                  (count == 0 ? "none" : std::to_string(count));
  return error;
}

}  // namespace evenlift::view
