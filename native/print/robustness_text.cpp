#include "print/robustness_text.h"

#include <algorithm>

#include "evenlift/capacity.h"
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

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

Row failure_row(std::size_t robot, std::size_t team, const std::optional<RestOfRobots>& rest,
                double largest) {
  Row row = {std::to_string(robot + 1), std::to_string(team + 1), yes_or_no(rest.has_value())};
  if (!rest) {
    row.resize(10, "-");
    return row;
  }
  const double distance = rest->tipping_distance;
  for (const std::string& cell :
       {yes_or_no(rest->clear), amount(distance, distance), percentage(rest->coverage, 1),
        yes_or_no(rest->form_closure),
        rest->greatest_by_plan ? amount(*rest->greatest_by_plan, largest) : std::string("-"),
        amount(rest->greatest_by_springs, largest), amount(rest->least_greatest, largest)})
    row.push_back(cell);
  return row;
}

}  // namespace

void RobustnessOptions::declare(CommandLine& line) {
  line.value(loads, "--loads", "MODEL",
             "loads in the table: plan (default), springs, best or worst");
  line.flag(failures, "--failures", "for each robot, what happens if it fails");
}

RobustnessAsked::RobustnessAsked(const RobustnessOptions& options, const Shown& shown)
    : com_radius(shown.com_radius), failures(options.failures) {
  if (options.loads) model = loads_option(*options.loads);
  if (com_radius > 0 && !has_ranges(model))
    throw Failure{
        bad_input_status, "--loads",
        "with a C uncertainty of " + with_length_unit(plain(com_radius), shown.units) +
            ", only plan and springs can be shown; choose one of them, or set --com-radius 0"};
}

RobustnessKnown::RobustnessKnown(const Placement& placement, const RobustnessAsked& wanted)
    : asked(wanted) {
  if (placement.teams.empty()) return;
  robustness = evenlift::robustness(placement);
  if (asked.model != LoadModel::plan || asked.com_radius > 0) models = model_loads(placement);
  if (asked.failures) failures = single_failures(placement);
}

ShownLoads shown_loads(const Placement& placement, const RobustnessKnown& known) {
  const LoadModel model = known.models ? known.asked.model : LoadModel::plan;
  ShownLoads shown{
      heading(model), {}, {}, loads_by(model, placement, known.models, known.asked.com_radius)};
  for (const LoadRange& range : shown.ranges) shown.greatest.push_back(range.greatest);
  const double largest = *std::max_element(shown.greatest.begin(), shown.greatest.end());
  for (const LoadRange& range : shown.ranges)
    shown.text.push_back(amounts(range.least, range.greatest, largest));
  return shown;
}

std::string robustness_lines(const ShownPlacement& of, const RobustnessKnown& known) {
  if (!of.placement.loads) return {};
  const Units& units = of.shown.units;
  const RobustnessAsked& asked = known.asked;
  std::string text;
  if (known.models && asked.model != LoadModel::plan)
    text += model_in_words(asked.model, *known.models, units) + "\n";
  if (known.models && asked.com_radius > 0) {
    text += uncertainty_in_words(*known.models, known.robustness, asked.com_radius, units);
    if (has_capacities(of))
      text += " " + uncertainty_for_capacity_in_words(*known.models, known.robustness, of);
    text += "\n";
  }
  if (!known.failures.empty())
    text += failures_in_words(known.failures, units, overloads_after(of, known.failures),
                              has_capacities(of) ? limit_in_words(of) : std::string()) +
            "\n";
  return text;
}

std::string failure_table(const ShownPlacement& of, const RobustnessKnown& known) {
  if (known.failures.empty()) return {};
  const std::vector<bool> overloads = overloads_after(of, known.failures);
  double largest = 0;
  for (const auto& rest : known.failures)
    if (rest)
      largest = std::max({largest, rest->greatest_by_plan.value_or(0), rest->greatest_by_springs});
  std::vector<Row> rows = {{"fails", "of team", "carried", "steady", "tipping distance", "coverage",
                            "form closure", "by plan", "springs", "best"}};
  if (has_capacities(of)) rows[0].push_back("overloaded");
  for (std::size_t robot = 0; robot < known.failures.size(); ++robot) {
    const std::optional<RestOfRobots>& rest = known.failures[robot];
    rows.push_back(failure_row(robot, find_robot(of.placement.teams, robot).team, rest, largest));
    if (has_capacities(of)) rows.back().push_back(overloads[robot] ? "yes" : "-");
  }
  return table(rows);
}

}  // namespace evenlift::native
