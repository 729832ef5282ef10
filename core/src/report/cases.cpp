#include "evenlift/cases.h"

#include <algorithm>
#include <array>

#include "evenlift/capacity.h"
#include "evenlift/report.h"

namespace evenlift {
namespace {

using Loading = LoadCase::Kind;

// The conditions of `shown` that are of this kind.
Shown only(Loading kind, const Shown& shown) {
  Shown one = shown;
  if (kind == Loading::all) return one;
  if (kind != Loading::com) one.com_radius = 0;
  if (kind != Loading::slope) one.carrying.slope = 0;
  if (kind != Loading::acceleration) one.carrying.acceleration = 0;
  if (kind != Loading::uneven) one.carrying.uneven = 0;
  return one;
}

bool is_given(Loading kind, const Shown& shown) {
  const Disturbance one = disturbance_of(only(kind, shown));
  return one.any();
}

void look_at(LoadCase& found, const Report& report) {
  const auto& loads = report.planned;
  if (!found.stays || loads.empty()) return;
  const auto greatest = std::max_element(
      loads.begin(), loads.end(),
      [](const LoadRange& a, const LoadRange& b) { return a.greatest < b.greatest; });
  found.robot = static_cast<std::size_t>(greatest - loads.begin());
  found.greatest = greatest->greatest;
  found.least = std::min_element(loads.begin(), loads.end(), [](const auto& a, const auto& b) {
                  return a.least < b.least;
                })->least;
  if (const auto most = report.most_used()) found.use = report.use[*most];
}

LoadCase case_of(Loading kind, const ShownPlacement& of) {
  LoadCase found{.kind = kind};
  Placement placement = of.placement;
  placement.weighing.reset();  // what follows from it is in `shown`
  const Shown shown = only(kind, of.shown);
  const Report report = report_of({placement, shown});
  found.stays = placement.loads && !report.tips;
  look_at(found, report);
  return found;
}

LoadCase after_failure(std::size_t robot, const std::optional<RestOfRobots>& rest,
                       const std::vector<std::optional<double>>& limits, bool disturbed) {
  LoadCase found{.kind = Loading::failure, .failed = robot};
  found.stays = rest && rest->steady && rest->stays;
  if (!found.stays) return found;
  const std::vector<double>& loads = rest->ends;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    if (i == robot) continue;
    if (!found.greatest || loads[i] > *found.greatest) {
      found.greatest = loads[i];
      found.robot = i;
    }
    if (!disturbed) found.least = std::min(found.least.value_or(loads[i]), loads[i]);
    if (i < limits.size() && limits[i])
      found.use = std::max(found.use.value_or(0), loads[i] / *limits[i]);
  }
  return found;
}

}  // namespace

std::string_view name(LoadCase::Kind kind) {
  constexpr std::array<std::string_view, 7> names{"level",  "com", "slope",  "acceleration",
                                                  "uneven", "all", "failure"};
  return names[static_cast<std::size_t>(kind)];
}

std::vector<LoadCase> load_cases(const ShownPlacement& of) {
  std::vector<LoadCase> cases;
  if (of.placement.teams.empty()) return cases;
  cases.push_back(case_of(Loading::level, of));
  for (const Loading kind : {Loading::com, Loading::slope, Loading::acceleration, Loading::uneven})
    if (is_given(kind, of.shown)) cases.push_back(case_of(kind, of));
  if (cases.size() > 2) cases.push_back(case_of(Loading::all, of));
  const Disturbance disturbance = disturbance_of(of.shown);
  const auto failures = single_failures(of.placement, disturbance);
  const auto limits = limits_of(of);
  for (std::size_t i = 0; i < failures.size(); ++i)
    cases.push_back(after_failure(i, failures[i], limits, disturbance.any()));
  return cases;
}

std::optional<std::size_t> worst_case(const std::vector<LoadCase>& cases) {
  std::optional<std::size_t> worst;
  const auto is_worse = [&](const LoadCase& a, const LoadCase& b) {
    if (a.stays != b.stays) return !a.stays;
    if (a.use && b.use) return *a.use > *b.use;
    return a.greatest.value_or(0) > b.greatest.value_or(0);
  };
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (!worst || is_worse(cases[i], cases[*worst])) worst = i;
  return worst;
}

}  // namespace evenlift
