#include <algorithm>

#include "evenlift/experiment/figures.h"
#include "evenlift/wording.h"
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
  return " " + say(settings.samples == 1 ? "Random is the mean of {number} placement."
                                         : "Random is the mean of {number} placements.",
                   {settings.samples});
}

// "With 6 robots: 12.3 kg by area, ... and 15.0 kg at random."
template <class Write>
std::string by_every_method(const PolygonResult& result, Value value, Write write) {
  const std::uint32_t robots = std::min<std::uint32_t>(6, most_robots(result));
  std::vector<std::string> items;
  for (const Method method : all_methods)
    if (const Measurement* m = find(result, method, robots))
      items.push_back(write(m->*value) + " " + by(method));
  return say("With {robots} robots: {values}.", {robots, listed(items)});
}

bool has(const PolygonResult& result, Method method) {
  return std::any_of(result.measurements.begin(), result.measurements.end(),
                     [&](const Measurement& m) { return m.method == method; });
}

// "by area with 8 robots", "by circle with none": the smallest number of robots in form closure.
std::string first_closed(const PolygonResult& result, Method method) {
  for (const Measurement& m : result.measurements)
    if (m.method == method && m.form_closure > 0)
      return say("{how} with {robots} robots", {by(method), m.robots});
  return say("{how} with none", {by(method)});
}

// At equal angles and in balance, each number of robots has its own placement, so form closure may
// be lost again. `sentence` has a place for the numbers.
std::string lost_again(const PolygonResult& result, Method method, const char* sentence) {
  std::vector<std::string> numbers;
  const Measurement* before = nullptr;
  for (const Measurement& m : result.measurements) {
    if (m.method != method) continue;
    if (before && before->form_closure > 0 && m.form_closure == 0)
      numbers.push_back(std::to_string(m.robots));
    before = &m;
  }
  if (numbers.empty()) return "";
  return " " + say(sentence, {listed(numbers)});
}

std::string closure_sentence(const PolygonResult& result) {
  std::vector<std::string> items;
  for (const Method method : all_methods)
    if (method != Method::random && has(result, method))
      items.push_back(first_closed(result, method));
  return say("First in form closure {how}.", {listed(items)}) +
         lost_again(result, Method::distributed,
                    "Equal angles lose it again with {numbers} robots.") +
         lost_again(result, Method::balanced,
                    "Balanced robots lose it again with {numbers} robots.") +
         " " + say("For random, the chart shows the share of placements in form closure.");
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
