#include "evenlift/report.h"

#include <algorithm>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "report/accuracy_of.h"

namespace evenlift {
namespace {

double near(const ShownPlacement& of) { return near_distance(of.placement.polygon().diameter()); }

// The edge of the lifting base nearest to C.
std::optional<TippingLine> tipping_line(const Placement& placement, double distance) {
  if (!placement.loads) return std::nullopt;
  const Points robots = positions(lifting_points(placement.teams));
  const auto robot_at = [&](const Vec2& corner) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < robots.size(); ++i)
      if (squared_length(robots[i] - corner) < squared_length(robots[nearest] - corner))
        nearest = i;
    return nearest;
  };
  const Points& base = placement.lifting_base;
  TippingLine line;
  line.distance = distance;
  if (base.size() < 3) {
    if (!base.empty()) line.robots = {robot_at(base.front()), robot_at(base.back())};
    return line;
  }
  std::size_t least = 0;
  const auto to_edge = [&](std::size_t i) {
    const Vec2 &a = base[i], &b = base[(i + 1) % base.size()];
    return orient(a, b, placement.centre_of_mass) / length(b - a);
  };
  for (std::size_t i = 1; i < base.size(); ++i)
    if (to_edge(i) < to_edge(least)) least = i;
  line.robots = {robot_at(base[least]), robot_at(base[(least + 1) % base.size()])};
  std::sort(line.robots.begin(), line.robots.end());
  return line;
}

bool is_upright(const ShownPlacement& of, const Report& known) {
  if (!known.tipping_line || known.tips) return false;
  const double inside = std::max(hold_requirements(of.placement).inside,
                                 known.effect.reach + of.placement.settings.accuracy.value_or(0));
  return known.tipping_line->distance >= inside - near(of);
}

void add_standing(Report& report, const ShownPlacement& of) {
  const Placement& placement = of.placement;
  report.disturbance = disturbance_of(of.shown);
  report.effect = effect_on(of);
  report.equilibrium = equilibrium(placement);
  report.robustness = robustness(placement);
  const double size = placement.polygon().diameter(), tips_at = report.robustness.tipping_distance;
  report.tips = !is_within_base(report.effect.reach, tips_at, size);
  report.tilt = tilt_of(report.disturbance, report.effect, tips_at, size);
  if (report.tilt && !placement.loads) report.tilt->stays = false;  // falls on level ground
  report.tipping_line = tipping_line(placement, tips_at);
  report.upright = is_upright(of, report);
  report.firm = hold_firmly(placement);
  report.held = is_held(placement);
  report.misfits = misfits(placement);
}

void add_models(Report& report, const ShownPlacement& of) {
  if (!report.models) report.models = model_loads(of.placement, report.disturbance);
}

std::vector<double> greatest_of(const std::vector<LoadRange>& loads) {
  std::vector<double> greatest;
  for (const LoadRange& load : loads) greatest.push_back(load.greatest);
  return greatest;
}

void tell_overloads(Report& report, const ShownPlacement& of) {
  report.greatest = 0;
  for (const LoadRange& load : report.loads)
    report.greatest = std::max(report.greatest, load.greatest);
  report.overloaded = overloaded_robots(of, greatest_of(report.loads));
}

// By the model that is shown.
void tell(Report& report, const ShownPlacement& of, LoadModel model) {
  report.known.model = model;
  report.model = report.models ? model : LoadModel::plan;
  report.loads = report.model == LoadModel::plan
                     ? report.planned
                     : shown_loads(of.placement, report.model, report.models, report.tips);
  tell_overloads(report, of);
}

void add_loads(Report& report, const ShownPlacement& of, LoadModel model) {
  if (report.disturbance.any() || model != LoadModel::plan) add_models(report, of);
  const auto& conditions = report.disturbance.any() ? report.models : std::nullopt;
  report.planned = shown_loads(of.placement, LoadModel::plan, conditions, report.tips);
  report.loads_are_determined = loads_are_determined(of.placement);
  report.worst = worst_loads(of.placement, report.effect);
  if (report.has_capacities) report.capacities = capacities_of(of);
  if (report.worst) report.overloaded_at_worst = overloaded_robots(of, *report.worst);
  report.overloaded_as_planned = overloaded_robots(of, greatest_of(report.planned));
  report.overloaded_at_rest = overloaded_robots(of);
  tell(report, of, model);
}

// The changes of loads by everything but the error of C.
LoadChanges changes_besides_com(const Report& report, const ShownPlacement& of) {
  if (!report.disturbance.besides_com()) return {};
  if (report.disturbance.com_radius == 0) return report.models->changes;
  Disturbance besides = report.disturbance;
  besides.com_radius = 0;
  const auto models = model_loads(of.placement, besides);
  return models ? models->changes : LoadChanges{};
}

void add_com_radius(Report& report, const ShownPlacement& of) {
  if (report.com_radius || !report.models || report.capacities.empty()) return;
  const LoadChanges changes = changes_besides_com(report, of);
  const auto within = [&](const std::vector<std::optional<double>>& limits) {
    return radius_within_capacity(report.models->springs, report.robustness.tipping_distance,
                                  limits, changes);
  };
  const std::vector<std::optional<double>> no_limits(report.capacities.size());
  report.com_radius = {within(report.capacities), within(no_limits)};
}

}  // namespace

Report report_of(const ShownPlacement& of, const Asked& asked) {
  Report report;
  report.has_capacities = has_capacities(of);
  report.has_own_capacities = has_own_capacities(of);
  if (!of.placement.teams.empty()) {
    add_standing(report, of);
    add_loads(report, of, asked.model);
    report.accuracy = accuracy_of(of, report);
    report.extra = extra_load(of);
  }
  complete(report, of, asked);
  return report;
}

void complete(Report& report, const ShownPlacement& of, const Asked& asked) {
  if (const auto& limit = of.shown.capacity; asked.plans && report.has_capacities) {
    if (!report.plan) report.plan = limit ? plan_capacity(of.placement, *limit) : CapacityPlan{};
    if (!report.if_one_fails)
      report.if_one_fails = limit ? plan_for_failures(of, *limit) : FailurePlan{};
  }
  const bool has_robots = !of.placement.teams.empty();
  if (has_robots) {
    if (asked.models || asked.model != LoadModel::plan) add_models(report, of);
    if (asked.model != report.known.model) tell(report, of, asked.model);
    add_com_radius(report, of);
    if (asked.models && report.models && !report.inexact_models)
      report.inexact_models = with_inaccuracy(*report.models, of.placement);
  }
  if (asked.failures && has_robots && report.failures.empty()) {
    report.failures = single_failures(of.placement, report.disturbance);
    if (report.has_capacities) report.overloads_after = overloads_after(of, report.failures);
  }
  report.known.models |= asked.models;
  report.known.failures |= asked.failures;
  report.known.plans |= asked.plans;
}

Report report_of_failure(const ShownPlacement& failing, std::size_t robot,
                         const std::optional<RestOfRobots>& rest, std::vector<LoadRange> loads) {
  Report report;
  report.has_capacities = has_capacities(failing);
  report.has_own_capacities = has_own_capacities(failing);
  add_standing(report, failing);
  report.tips = rest && !rest->stays;
  report.planned = loads_by(LoadModel::plan, failing.placement, std::nullopt);
  if (report.has_capacities) report.capacities = capacities_of(failing);
  report.model = LoadModel::springs;
  report.loads = loads.empty() ? report.planned : std::move(loads);
  tell_overloads(report, failing);
  report.overloaded_as_planned = report.overloaded;
  report.accuracy = accuracy_of(failing, report);
  report.failed = robot;
  return report;
}

}  // namespace evenlift
