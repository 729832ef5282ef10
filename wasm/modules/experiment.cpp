// The experiment: its measurements and their averages.
#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/experiment/outputs.h"
#include "evenlift/import.h"
#include "evenlift/output/json_text.h"
#include "evenlift/wording.h"
#include "modules/kinds.h"

namespace evenlift::view {
namespace {

std::string problem_of(const InputError& error) {
  const std::string place = describe(error.place);
  const std::string message(translated(error.message));
  return place.empty() ? message : place + ": " + message;
}

experiment::PolygonResult refused(const std::string& set, const std::string& name,
                                  const std::string& why) {
  experiment::PolygonResult result;
  result.set = set;
  result.polygon = name;
  result.problem = why;
  return result;
}

// A polygon's result, or why there is none. `only` restricts it to one method.
experiment::PolygonResult measured(const std::string& set, const std::string& name,
                                   const std::string& text, std::optional<Method> only,
                                   const experiment::ExperimentSettings& settings) {
  const Result<Import> import = read_shapes(text);
  if (!import) return refused(set, name, problem_of(import.error()));
  if (import->shapes.size() != 1)
    return refused(
        set, name,
        say("it has {shapes} shapes; here a file may have only one", {import->shapes.size()}));
  const Document& document = import->shapes.front().document;
  const Result<experiment::Subject> subject = experiment::prepare(document, settings);
  if (!subject) return refused(set, name, problem_of(subject.error()));
  experiment::PolygonResult result = experiment::result_of(set, name, *subject);
  for (const Method method : all_methods) {
    if (only && *only != method) continue;
    for (experiment::Measurement& m : experiment::measure(*subject, method, settings))
      result.measurements.push_back(std::move(m));
  }
  return result;
}

std::uint32_t whole_or_none(double value, std::uint32_t most) {
  return value >= 1 && value <= most ? static_cast<std::uint32_t>(value) : 0;
}

experiment::ExperimentSettings settings_of(const RequestMembers& members) {
  experiment::ExperimentSettings given{
      members.number("minRatio"), whole_or_none(members.number("samples"), experiment::max_samples),
      whole_or_none(members.number("mostTeams"), experiment::max_experiment_teams),
      whole_or_none(members.number("mostBalanced"), most_robots), members.number("weight")};
  for (const WeightUnit unit : all_weight_units)
    if (name(unit) == members.text("weightUnit")) given.weight_unit = unit;
  return given;
}

// Sorted by set and polygon; merges the results of a polygon that was measured method by method.
std::vector<experiment::PolygonResult> merged(std::vector<experiment::PolygonResult> parts) {
  std::vector<experiment::PolygonResult> whole;
  experiment::sort_results(parts);
  for (experiment::PolygonResult& part : parts) {
    if (whole.empty() || whole.back().set != part.set || whole.back().polygon != part.polygon) {
      whole.push_back(std::move(part));
      continue;
    }
    std::vector<experiment::Measurement>& rows = whole.back().measurements;
    rows.insert(rows.end(), part.measurements.begin(), part.measurements.end());
  }
  for (experiment::PolygonResult& result : whole)
    std::sort(result.measurements.begin(), result.measurements.end(),
              [](const experiment::Measurement& a, const experiment::Measurement& b) {
                return std::pair(a.method, a.robots) < std::pair(b.method, b.robots);
              });
  return whole;
}

}  // namespace

std::string measure(const RequestMembers& members) {
  experiment::Part part;
  part.settings = settings_of(members);
  if (const auto wrong = experiment::check_settings(part.settings)) return problem(wrong->message);
  const std::string set = members.text("set"), name = members.text("name"),
                    problem = members.text("problem");
  part.result = problem.empty() ? measured(set, name, members.text("text"),
                                           method_from_name(members.text("method")), part.settings)
                                : refused(set, name, problem);
  return json::object({{"part", json::text(experiment::write_part(part))}});
}

std::string results(const RequestMembers& members) {
  std::vector<experiment::PolygonResult> parts;
  for (const std::string& text : members.texts("parts")) {
    std::optional<experiment::Part> part = experiment::read_part(text);
    if (!part) return problem("a part cannot be read");
    parts.push_back(std::move(part->result));
  }
  std::vector<experiment::PolygonResult> whole = merged(std::move(parts));
  if (members.number("onePolygon") != 0 && !whole.empty())
    return experiment::outputs_json(
        experiment::make_polygon_outputs(whole.front(), settings_of(members)));
  return experiment::outputs_json(
      experiment::make_outputs(experiment::group_by_set(std::move(whole))));
}

}  // namespace evenlift::view
