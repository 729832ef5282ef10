#include "print/table.h"

#include <algorithm>
#include <tuple>

#include "evenlift/output/carrying_words.h"
#include "evenlift/output/markup.h"
#include "evenlift/output/robustness_words.h"
#include "evenlift/output/weighing_words.h"
#include "evenlift/output/words.h"
#include "input/command_line.h"
#include "input/options.h"

namespace evenlift::native {

std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i)
      widths[i] = std::max(widths[i], character_count(row[i]));
  std::string text;
  for (std::size_t at = 0; at < rows.size(); ++at) {
    const Row& row = rows[at];
    for (std::size_t i = 0; i < row.size(); ++i)
      text += "  " + std::string(widths[i] - character_count(row[i]), ' ') + row[i];
    if (at < remarks.size() && !remarks[at].empty()) text += "  " + remarks[at];
    text += "\n";
  }
  return text;
}

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
std::string numbers_of(const Placement& placement, const std::vector<std::size_t>& robots) {
  std::string text;
  for (const std::size_t robot : robots)
    text += (text.empty() ? "" : ", ") + std::to_string(placement.number_of(robot));
  return text.empty() ? "-" : text;
}

std::string yes_or_no(bool value) { return value ? "yes" : "no"; }

Row failure_row(const std::string& robot, std::size_t team, const std::optional<RestOfRobots>& rest,
                double largest, bool with_disturbance) {
  Row row = {robot, std::to_string(team + 1), yes_or_no(rest.has_value())};
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

Asked asked_by(const RobustnessOptions& options, const Shown& shown) {
  Asked asked{.failures = options.failures};
  if (options.loads) asked.model = loads_option(*options.loads);
  if (disturbance_of(shown).any() && !has_ranges(asked.model))
    throw Failure{bad_input_status, "--loads",
                  disturbance_in_words(shown) +
                      ", only plan and springs can be shown; choose one of them, or leave out "
                      "these conditions"};
  return asked;
}

LoadColumn load_column(const Reported& of) {
  const auto& [model, loads, largest] =
      std::tie(of.report.model, of.report.loads, of.report.greatest);
  LoadColumn column{heading(model), {}, {}};
  bool is_bound = model == LoadModel::worst;
  for (const LoadRange& range : loads) {
    is_bound = is_bound || range.least < range.greatest;
    column.text.push_back(has_ranges(model) ? amounts(range, largest)
                                            : amount(range.greatest, largest, Toward::up));
  }
  column.overloaded = is_bound ? "can be overloaded" : "overloaded";
  return column;
}

std::string robustness_lines(const Reported& of) {
  if (!of.placement.loads) return {};
  std::string text;
  for (const std::string& line :
       {model_in_words(of), uncertainty_in_words(of), given_in_part_in_words(of), tilt_in_words(of),
        extra_in_words(of), failures_in_words(of)})
    if (!line.empty()) text += line + "\n";
  return text;
}

std::string case_table(const Reported& of, const std::vector<LoadCase>& cases) {
  const auto row_of = [](const CaseInWords& words) {
    Row row{words.name, words.greatest, words.robot, words.least};
    if (!words.use.empty()) row.push_back(words.use);
    row.push_back(words.stays);
    return row;
  };
  std::vector<Row> rows{row_of(headings_of_cases(of))};
  for (const CaseInWords& words : cases_in_words(of, cases)) rows.push_back(row_of(words));
  std::vector<std::string> remarks(rows.size());
  if (const auto worst = worst_case(cases)) remarks[*worst + 1] = "worst";
  return table(rows, remarks);
}

std::string failure_table(const Reported& of) {
  const auto& failures = of.report.failures;
  if (failures.empty()) return {};
  double largest = 0;
  for (const auto& rest : failures)
    if (rest)
      largest = std::max({largest, rest->greatest_by_plan.value_or(0), rest->greatest_by_springs,
                          rest->greatest_end.value_or(0)});
  std::vector<Row> rows = {{"fails", "of team", "carried", "steady", "tipping distance", "coverage",
                            "form closure", "by plan", "springs", "best"}};
  const bool with_disturbance = of.report.disturbance.any(), capacities = of.report.has_capacities;
  if (with_disturbance)
    for (const char* heading : {"at most", "stays"}) rows[0].push_back(heading);
  if (capacities) rows[0].push_back(with_disturbance ? "can be overloaded" : "overloaded");
  for (std::size_t robot = 0; robot < failures.size(); ++robot) {
    const std::optional<RestOfRobots>& rest = failures[robot];
    rows.push_back(failure_row(of.placement.called(robot),
                               find_robot(of.placement.teams, robot).team, rest, largest,
                               with_disturbance));
    if (capacities)
      rows.back().push_back(
          rest && rest->stays ? numbers_of(of.placement, overloaded_robots(of, rest->ends)) : "-");
  }
  return table(rows);
}

}  // namespace evenlift::native
