#include "derive/reports.h"

#include <utility>
#include <vector>

namespace evenlift::view {
namespace {

// The others share the weight by springs, whichever model is shown.
Report report_of(const Placement& placement, const Failure& failure, const Shown& shown) {
  const Disturbance disturbance = disturbance_of(shown);
  const bool stays = failure.rest && failure.rest->stays;
  auto loads = disturbance.any() && stays ? ranges_without(placement, failure.robot, disturbance)
                                          : std::nullopt;
  return report_of_failure({failure.placement, shown}, failure.robot, failure.rest,
                           std::move(loads).value_or(std::vector<LoadRange>()));
}

// A millisecond or two at most, for each frame of a drag.
bool is_quick(const Placement& placement) {
  return count_robots(placement.teams) <= 16 && placement.vertices().size() <= 2000;
}

}  // namespace

void renew_reports(Derived& facts, LoadModel model, const Shown& shown) {
  if (!facts.placement) return;
  const ShownPlacement of(*facts.placement, shown);
  Report report = evenlift::report_of(of, {.model = model});
  if (!facts.failures_due && !facts.report.failures.empty()) {
    report.failures = std::move(facts.report.failures);
    if (report.has_capacities) report.overloads_after = overloads_after(of, report.failures);
  }
  facts.report = std::move(report);
  facts.second_report =
      facts.second ? evenlift::report_of({*facts.second, shown}, {.model = model}) : Report{};
  if (facts.failure) facts.failure->report = report_of(*facts.placement, *facts.failure, shown);
}

void renew_failures(Derived& facts, const Shown& shown, bool move) {
  if (!facts.failures_due || !facts.placement || facts.refusal) return;
  const Placement& placement = *facts.placement;
  if (move && !is_quick(placement)) return;
  facts.failures_due = false;
  facts.report.failures.clear();
  if (count_robots(placement.teams) <= most_failures_known)
    complete(facts.report, {placement, shown},
             {.model = facts.report.known.model, .failures = true});
}

void tell_plans(Derived& facts) {
  facts.report.plan = facts.plan_due ? std::nullopt : facts.plan;
  facts.report.if_one_fails = facts.plan_due ? std::nullopt : facts.spare;
  if (facts.failure) facts.failure->report.plan = facts.report.plan;
}

void let_fail(Derived& facts, std::size_t robot, const Shown& shown) {
  facts.failure.reset();
  const Placement& placement = *facts.placement;
  if (robot >= count_robots(placement.teams)) return;
  const bool known = robot < facts.report.failures.size();
  Failure failure{robot,
                  known ? facts.report.failures[robot]
                        : single_failure(placement, robot, disturbance_of(shown)),
                  with_failure(placement, robot),
                  {}};
  failure.report = report_of(placement, failure, shown);
  facts.failure = std::move(failure);
}

}  // namespace evenlift::view
