// The experiment for the page: a WebAssembly module of its own, for web/experiment_worker.js. It
// knows the core, and nothing of the view.
#include <emscripten/emscripten.h>

#include <string>
#include <utility>
#include <vector>

#include "evenlift/experiment/outputs.h"
#include "evenlift/formats.h"

namespace evenlift {
namespace {

// Keeps a text alive for JavaScript to read.
const char* hand_over(std::string text) {
  static std::string kept;
  kept = std::move(text);
  return kept.c_str();
}

// What the results are made of, until they are.
std::vector<PolygonResult>& collected() {
  static std::vector<PolygonResult> results;
  return results;
}

std::string problem_of(const InputError& error) {
  const std::string place = describe(error.place);
  return place.empty() ? error.message : place + ": " + error.message;
}

// A polygon's result, or why there is none.
PolygonResult measured(const std::string& name, const char* text,
                       const ExperimentSettings& settings) {
  PolygonResult refused;
  refused.polygon = name;
  const Result<Document> document = read_polygon(text);
  if (!document) {
    refused.problem = problem_of(document.error());
    return refused;
  }
  const Result<Subject> subject = prepare(*document, settings.min_ratio);
  if (!subject) {
    refused.problem = problem_of(subject.error());
    return refused;
  }
  PolygonResult result = describe(name, *subject);
  for (const Metric method : all_metrics)
    for (Measurement& m : measure(*subject, method, settings))
      result.measurements.push_back(std::move(m));
  return result;
}

}  // namespace
}  // namespace evenlift

extern "C" {

// A polygon's part, as text (evenlift/experiment/results.h); settings as checked by
// experiment_problem.
EMSCRIPTEN_KEEPALIVE const char* experiment_measure(const char* name, const char* text,
                                                    double min_ratio, double samples) {
  using namespace evenlift;
  Part part;
  part.settings.min_ratio = min_ratio;
  part.settings.samples = static_cast<std::uint32_t>(samples);
  part.result = measured(name, text, part.settings);
  return hand_over(write_part(part));
}

// The part of what could not be read at all.
EMSCRIPTEN_KEEPALIVE const char* experiment_refuse(const char* name, const char* problem) {
  evenlift::Part part;
  part.result.polygon = name;
  part.result.problem = problem;
  return evenlift::hand_over(evenlift::write_part(part));
}

// Why settings are out of range; empty if they are not.
EMSCRIPTEN_KEEPALIVE const char* experiment_problem(double min_ratio, double samples) {
  using namespace evenlift;
  ExperimentSettings settings{.min_ratio = min_ratio};
  settings.samples =
      samples >= 1 && samples <= max_samples ? static_cast<std::uint32_t>(samples) : 0;
  const std::optional<InputError> error = check_settings(settings);
  return hand_over(error ? error->message : "");
}

// Takes a part to the results; 0 if it is none.
EMSCRIPTEN_KEEPALIVE int experiment_add(const char* text) {
  std::optional<evenlift::Part> part = evenlift::read_part(text);
  if (part) evenlift::collected().push_back(std::move(part->result));
  return part ? 1 : 0;
}

// The results of the parts that were taken, as JSON (outputs_json); begins anew after it.
EMSCRIPTEN_KEEPALIVE const char* experiment_results() {
  using namespace evenlift;
  std::vector<PolygonResult> results = std::exchange(collected(), {});
  sort_results(results);
  return hand_over(outputs_json(make_outputs(results)));
}

}  // extern "C"
