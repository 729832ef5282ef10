// The measurements of one polygon against the number of robots.
#include <algorithm>

#include "evenlift/experiment/figures.h"
#include "experiment/thesis/by_polygon.h"
#include "experiment/thesis/sentences.h"

namespace evenlift::experiment {
namespace {

using Value = double Measurement::*;

// The greatest number of robots in teams of two, or of balanced robots if there are no teams.
std::uint32_t most_robots(const PolygonResult& result) {
  std::uint32_t in_teams = 0, balanced = 0;
  for (const Measurement& m : result.measurements) {
    std::uint32_t& most = m.method == Method::balanced ? balanced : in_teams;
    most = std::max(most, m.robots);
  }
  return in_teams > 0 ? in_teams : balanced;
}

std::string random_note(const ExperimentSettings& settings) {
  return " Random is the mean of " + std::to_string(settings.samples) + " placement" +
         (settings.samples == 1 ? "." : "s.");
}

// "With 6 robots 12.3 kg by area, ... and 15.0 kg at random."
template <class Write>
std::string by_every_method(const PolygonResult& result, Value value, Write write) {
  const std::uint32_t robots = std::min<std::uint32_t>(6, most_robots(result));
  std::vector<std::string> items;
  for (const Method method : all_methods)
    if (const Measurement* m = find(result, method, robots))
      items.push_back(write(m->*value) + " " + by(method));
  return "With " + of_robots(robots) + ": " + listed(items) + ".";
}

bool has(const PolygonResult& result, Method method) {
  return std::any_of(result.measurements.begin(), result.measurements.end(),
                     [&](const Measurement& m) { return m.method == method; });
}

// "by area with 8 robots", "by circle with none": the smallest number of robots in form closure.
std::string first_closed(const PolygonResult& result, Method method) {
  for (const Measurement& m : result.measurements)
    if (m.method == method && m.form_closure > 0)
      return by(method) + " with " + of_robots(m.robots);
  return by(method) + " with none";
}

// Equal angles and balanced robots are placed independently for each number, so form closure may be
// lost again. `who` names these robots.
std::string lost_again(const PolygonResult& result, Method method, const std::string& who) {
  std::vector<std::string> numbers;
  const Measurement* before = nullptr;
  for (const Measurement& m : result.measurements) {
    if (m.method != method) continue;
    if (before && before->form_closure > 0 && m.form_closure == 0)
      numbers.push_back(std::to_string(m.robots));
    before = &m;
  }
  if (numbers.empty()) return "";
  return " " + who + " lose it again with " + listed(numbers) + " robots.";
}

std::string closure_sentence(const PolygonResult& result) {
  std::vector<std::string> items;
  for (const Method method : all_methods)
    if (method != Method::random && has(result, method))
      items.push_back(first_closed(result, method));
  return "First in form closure " + listed(items) + "." +
         lost_again(result, Method::distributed, "Equal angles") +
         lost_again(result, Method::balanced, "Balanced robots") +
         " For random, the chart shows the share of placements in form closure.";
}

Figure figure_of(const PolygonResult& result, const char* id, const char* title,
                 const std::string& unit, Value value, const std::string& sentence) {
  Figure figure{"", id, title, unit, id, sentence, {}};
  for (const Measurement& m : result.measurements) {
    if (figure.series.empty() || figure.series.back().method != m.method)
      figure.series.push_back({m.method, {}});
    figure.series.back().points.push_back({m.robots, m.*value, 1});
  }
  return figure;
}

}  // namespace

std::vector<Figure> make_polygon_figures(const PolygonResult& result,
                                         const ExperimentSettings& settings) {
  if (result.measurements.empty()) return {};
  const std::string unit(name(settings.weight_unit));
  const auto weighed = [&](double load) { return in_unit(load, unit); };
  return {
      figure_of(result, "load_max", "Greatest load of a robot", unit, &Measurement::load_max,
                by_every_method(result, &Measurement::load_max, weighed) + random_note(settings)),
      figure_of(result, "spread", "Spread of loads: the greatest less the least load of a robot",
                unit, &Measurement::spread, by_every_method(result, &Measurement::spread, weighed)),
      figure_of(result, "coverage", "Coverage: share of the object above the lifting base", "%",
                &Measurement::coverage,
                by_every_method(result, &Measurement::coverage, in_percent)),
      figure_of(result, "form_closure", "Form closure", "%", &Measurement::form_closure,
                closure_sentence(result))};
}

}  // namespace evenlift::experiment
