#include "print/robustness_text.h"

#include <algorithm>

#include "evenlift/capacity.h"
#include "evenlift/output/carrying_words.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/words.h"
#include "input/failure.h"
#include "input/options.h"
#include "print/table.h"

namespace evenlift::native {
namespace {

const char* heading(LoadModel model) {
  switch (model) {
    case LoadModel::plan:
    case LoadModel::springs:
      return "load";
    case LoadModel::best:
      return "at most";
    case LoadModel::worst:
      return "at worst";
  }
  return "";
}

// "2, 5"; "-" for an empty list.
std::string numbers_from_1(const std::vector<std::size_t>& robots) {
  std::string text;
  for (const std::size_t robot : robots)
    text += (text.empty() ? "" : ", ") + std::to_string(robot + 1);
  return text.empty() ? "-" : text;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

Row failure_row(std::size_t robot, std::size_t team, const std::optional<RestOfRobots>& rest,
                double largest, bool with_disturbance) {
  Row row = {std::to_string(robot + 1), std::to_string(team + 1), yes_or_no(rest.has_value())};
  if (!rest) {
    row.resize(with_disturbance ? 12 : 10, "-");
    return row;
  }
  const double distance = rest->tipping_distance;
  for (const std::string& cell :
       {yes_or_no(rest->clear), amount(distance, distance, Toward::down),
        percentage(rest->coverage, 1), yes_or_no(rest->form_closure),
        rest->greatest_by_plan ? amount(*rest->greatest_by_plan, largest, Toward::up)
                               : std::string("-"),
        amount(rest->greatest_by_springs, largest, Toward::up),
        amount(rest->least_greatest, largest, Toward::up)})
    row.push_back(cell);
  if (!with_disturbance) return row;
  row.push_back(rest->greatest_end ? amount(*rest->greatest_end, largest, Toward::up) : "-");
  row.push_back(yes_or_no(rest->stays));
  return row;
}

}  // namespace

void RobustnessOptions::declare(CommandLine& line) {
  line.value(loads, "--loads", "MODEL",
             "loads in the table: plan (default), springs, best or worst");
  line.flag(failures, "--failures", "for each robot, what happens if it fails");
}

RobustnessAsked::RobustnessAsked(const RobustnessOptions& options, const Shown& shown)
    : disturbance(disturbance_of(shown)), failures(options.failures) {
  if (options.loads) model = loads_option(*options.loads);
  if (disturbance.any() && !has_ranges(model))
    throw Failure{bad_input_status, "--loads",
                  disturbance_in_words(shown) +
                      ", only plan and springs can be shown; choose one of them, or leave out "
                      "these conditions"};
}

RobustnessKnown::RobustnessKnown(const Placement& placement, const RobustnessAsked& wanted)
    : asked(wanted) {
  if (placement.teams.empty()) return;
  robustness = evenlift::robustness(placement);
  if (asked.model != LoadModel::plan || asked.disturbance.any())
    models = model_loads(placement, asked.disturbance);
  if (asked.failures) failures = single_failures(placement, asked.disturbance);
}

ShownLoads loads_for_table(const ShownPlacement& of, const RobustnessKnown& known) {
  const LoadModel model = known.models ? known.asked.model : LoadModel::plan;
  ShownLoads shown{heading(model), {}, {}, shown_loads(of, model, known.models), {}};
  bool is_bound = model == LoadModel::worst;
  for (const LoadRange& range : shown.ranges) {
    shown.greatest.push_back(range.greatest);
    is_bound = is_bound || range.least < range.greatest;
  }
  shown.overloaded = is_bound ? "can be overloaded" : "overloaded";
  const double largest = *std::max_element(shown.greatest.begin(), shown.greatest.end());
  for (const LoadRange& range : shown.ranges)
    shown.text.push_back(has_ranges(model) ? amounts(range, largest)
                                           : amount(range.greatest, largest, Toward::up));
  return shown;
}

std::string robustness_lines(const ShownPlacement& of, const RobustnessKnown& known) {
  if (!of.placement.loads) return {};
  const Units& units = of.shown.units;
  const RobustnessAsked& asked = known.asked;
  std::string text;
  if (known.models && asked.model != LoadModel::plan)
    text += model_in_words(asked.model, *known.models, units) + "\n";
  if (known.models && asked.disturbance.any()) {
    std::string line = uncertainty_in_words(*known.models, known.robustness, of.shown);
    if (has_capacities(of) && !tips_when_disturbed(of))
      line += (line.empty() ? "" : " ") + uncertainty_for_capacity_in_words(*known.models, of);
    if (!line.empty()) text += line + "\n";
  }
  const std::string idle = given_in_part_in_words(of);
  if (!idle.empty()) text += idle + "\n";
  const std::string tilt = tilt_in_words(known.robustness, of);
  if (!tilt.empty()) text += tilt + "\n";
  if (const auto extra = extra_load(of)) text += extra_in_words(*extra, of) + "\n";
  if (!known.failures.empty())
    text += failures_in_words(known.failures, units, overloads_after(of, known.failures),
                              has_capacities(of) ? limit_in_words(of) : std::string(),
                              conditions_in_words(of.shown)) +
            "\n";
  return text;
}

std::string failure_table(const ShownPlacement& of, const RobustnessKnown& known) {
  if (known.failures.empty()) return {};
  double largest = 0;
  for (const auto& rest : known.failures)
    if (rest)
      largest = std::max({largest, rest->greatest_by_plan.value_or(0), rest->greatest_by_springs,
                          rest->greatest_end.value_or(0)});
  std::vector<Row> rows = {{"fails", "of team", "carried", "steady", "tipping distance", "coverage",
                            "form closure", "by plan", "springs", "best"}};
  const bool with_disturbance = known.asked.disturbance.any();
  if (with_disturbance)
    for (const char* heading : {"at most", "stays"}) rows[0].push_back(heading);
  if (has_capacities(of)) rows[0].push_back(with_disturbance ? "can be overloaded" : "overloaded");
  for (std::size_t robot = 0; robot < known.failures.size(); ++robot) {
    const std::optional<RestOfRobots>& rest = known.failures[robot];
    rows.push_back(failure_row(robot, find_robot(of.placement.teams, robot).team, rest, largest,
                               with_disturbance));
    if (has_capacities(of))
      rows.back().push_back(rest && rest->stays ? numbers_from_1(overloaded_robots(of, rest->ends))
                                                : "-");
  }
  return table(rows);
}

}  // namespace evenlift::native
