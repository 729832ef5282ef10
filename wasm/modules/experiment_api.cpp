// The experiment for the page: a separate WebAssembly module, which
// web/experiment/experiment_worker.js loads.
#include <emscripten/emscripten.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/experiment/outputs.h"
#include "evenlift/import.h"
#include "evenlift/wording.h"
#include "page/hand_over.h"

namespace evenlift {

using view::hand_over;

namespace {

std::vector<experiment::PolygonResult>& collected() {
  static std::vector<experiment::PolygonResult> results;
  return results;
}

// Checked by experiment_begin().
experiment::ExperimentSettings& settings() {
  static experiment::ExperimentSettings given;
  return given;
}

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
                                   const char* text, std::optional<Method> only) {
  const Result<Import> import = read_shapes(text);
  if (!import) return refused(set, name, problem_of(import.error()));
  if (import->shapes.size() != 1)
    return refused(
        set, name,
        say("it has {shapes} shapes; here a file may have only one", {import->shapes.size()}));
  const Document& document = import->shapes.front().document;
  const Result<experiment::Subject> subject = experiment::prepare(document, settings().min_ratio);
  if (!subject) return refused(set, name, problem_of(subject.error()));
  experiment::PolygonResult result = experiment::result_of(set, name, *subject);
  for (const Method method : all_methods) {
    if (only && *only != method) continue;
    for (experiment::Measurement& m : experiment::measure(*subject, method, settings()))
      result.measurements.push_back(std::move(m));
  }
  return result;
}

std::string part_of(experiment::PolygonResult result) {
  experiment::Part part;
  part.settings = settings();
  part.result = std::move(result);
  return experiment::write_part(part);
}

std::uint32_t whole_or_none(double value, std::uint32_t most) {
  return value >= 1 && value <= most ? static_cast<std::uint32_t>(value) : 0;
}

// Sorted by set and polygon; merges the results of a polygon that was measured method by method.
std::vector<experiment::PolygonResult> take_collected() {
  std::vector<experiment::PolygonResult> parts = std::exchange(collected(), {}), whole;
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
}  // namespace evenlift

extern "C" {

// Sets the settings of all later measurements. Returns a sentence if one is out of range, otherwise
// an empty text.
EMSCRIPTEN_KEEPALIVE const char* experiment_begin(double min_ratio, double samples, double weight,
                                                  const char* weight_unit, double most_teams,
                                                  double most_balanced) {
  using namespace evenlift;
  experiment::ExperimentSettings given{min_ratio, whole_or_none(samples, experiment::max_samples),
                                       whole_or_none(most_teams, experiment::max_experiment_teams),
                                       whole_or_none(most_balanced, most_robots), weight};
  for (const WeightUnit unit : all_weight_units)
    if (name(unit) == weight_unit) given.weight_unit = unit;
  const std::optional<InputError> error = experiment::check_settings(given);
  if (!error) settings() = given;
  return hand_over(error ? error->message : "");
}

// Measures all methods or the named one. Returns the polygon's part as text
// (evenlift/experiment/results.h).
EMSCRIPTEN_KEEPALIVE const char* experiment_measure(const char* set, const char* name,
                                                    const char* text, const char* method) {
  using namespace evenlift;
  return hand_over(part_of(measured(set, name, text, method_from_name(method))));
}

// The part of a polygon that could not be read.
EMSCRIPTEN_KEEPALIVE const char* experiment_refuse(const char* set, const char* name,
                                                   const char* problem) {
  using namespace evenlift;
  return hand_over(part_of(refused(set, name, problem)));
}

// Returns 0 if the text is not a part.
EMSCRIPTEN_KEEPALIVE int experiment_add(const char* text) {
  std::optional<evenlift::experiment::Part> part = evenlift::experiment::read_part(text);
  if (part) evenlift::collected().push_back(std::move(part->result));
  return part ? 1 : 0;
}

// Returns averages over sets, or the results of a single polygon, as JSON (outputs_json). Clears
// the added parts.
EMSCRIPTEN_KEEPALIVE const char* experiment_results(int one_polygon) {
  using namespace evenlift;
  std::vector<experiment::PolygonResult> results = take_collected();
  if (one_polygon && !results.empty())
    return hand_over(
        experiment::outputs_json(experiment::make_polygon_outputs(results.front(), settings())));
  return hand_over(experiment::outputs_json(
      experiment::make_outputs(experiment::group_by_set(std::move(results)))));
}

}  // extern "C"
