#include "evenlift/experiment/figures.h"

#include <algorithm>

#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/experiment/outputs.h"
#include "evenlift/output/json_text.h"
#include "evenlift/wording.h"
#include "experiment/thesis/by_polygon.h"

namespace evenlift::experiment {
namespace {

struct Plan {
  const char* id;
  const char* title;
  const char* unit;
  const char* column;
  Pick pick;
  Sentence sentence;
};

constexpr Plan plans[] = {
    {"5.3", "Spread of loads: the greatest less the least load of a robot", "kg", "spread_mean",
     pick_spread, spread_sentence},
    {"5.4", "Standard deviation of the spread of loads over the polygons", "kg", "spread_sd",
     [](const Aggregate& a) { return a.spread.deviation; }, spread_deviation_sentence},
    {"5.5", "Greatest share of its team’s load that a robot carries", "%", "max_share_mean",
     pick_share, share_sentence},
    {"5.6", "Standard deviation of the greatest share over the polygons", "%", "max_share_sd",
     [](const Aggregate& a) { return a.max_share.deviation; }, share_deviation_sentence},
    {"5.7", "Coverage: share of the object above the lifting base", "%", "coverage_mean",
     pick_coverage, coverage_sentence},
    {"5.8", "Standard deviation of coverage over the polygons", "%", "coverage_sd",
     [](const Aggregate& a) { return a.coverage.deviation; }, coverage_deviation_sentence},
    {"5.11", "Polygons in form closure", "%", "form_closure_mean", pick_closure, closure_sentence},
};

// The greatest numbers of robots in the charts: in teams of two, and balanced.
struct Shown {
  std::uint32_t in_teams = 0, balanced = 0;

  bool has(const Aggregate& a) const {
    return a.robots <= (a.method == Method::balanced ? balanced : in_teams);
  }
};

Figure make_figure(const Plan& plan, const SetAggregates& set, const Shown& shown) {
  Figure figure{set.set,   plan.id,     plan.title,
                plan.unit, plan.column, plan.sentence(set.aggregates, shown.in_teams),
                {}};
  for (const Aggregate& a : set.aggregates) {
    const std::optional<double> value = plan.pick(a);
    if (!shown.has(a) || !value) continue;
    if (figure.series.empty() || figure.series.back().method != a.method)
      figure.series.push_back({a.method, {}});
    figure.series.back().points.push_back(
        {a.robots, *value, std::string_view(plan.id) == "5.11" ? a.closable : a.polygons});
  }
  return figure;
}

std::string series_json(const FigureSeries& series) {
  std::vector<std::string> points;
  for (const FigurePoint& p : series.points)
    points.push_back(
        json::array({std::to_string(p.robots), json::number(p.value), std::to_string(p.polygons)}));
  return json::object(
      {{"method", json::text(name(series.method))}, {"points", json::array(points)}});
}

}  // namespace

std::uint32_t most_robots_shown(const std::vector<Aggregate>& aggregates, Method method) {
  std::uint32_t polygons = 0, most = 0;
  for (const Aggregate& a : aggregates)
    if (a.method == method) polygons = std::max(polygons, a.polygons);
  for (const Aggregate& a : aggregates)
    if (a.method == method && 5 * a.polygons >= polygons) most = std::max(most, a.robots);
  return most;
}

std::vector<Figure> make_figures(const SetAggregates& set) {
  const Shown shown{most_robots_shown(set.aggregates, Method::area),
                    most_robots_shown(set.aggregates, Method::balanced)};
  std::vector<Figure> figures;
  for (const Plan& plan : plans) figures.push_back(make_figure(plan, set, shown));
  return figures;
}

std::string figures_json(const std::vector<Figure>& figures) {
  std::vector<std::string> items;
  for (const Figure& figure : figures) {
    std::vector<std::string> series;
    for (const FigureSeries& s : figure.series) series.push_back(series_json(s));
    items.push_back(json::long_object({{"set", json::text(figure.set)},
                                       {"id", json::text(figure.id)},
                                       {"title", json::text(figure.title)},
                                       {"unit", json::text(figure.unit)},
                                       {"column", json::text(figure.column)},
                                       {"sentence", json::text(figure.sentence)},
                                       {"series", json::long_array(series, 2)}},
                                      1));
  }
  return json::long_array(items, 0) + "\n";
}

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

namespace {

// Sorts the figures of all sets by figure, then by set.
std::vector<Figure> by_figure(std::vector<std::vector<Figure>> sets) {
  std::vector<Figure> figures;
  for (std::size_t i = 0; !sets.empty() && i < sets.front().size(); ++i)
    for (std::vector<Figure>& set : sets) figures.push_back(std::move(set[i]));
  return figures;
}

void add_refused(const PolygonResult& result, Outputs& outputs) {
  if (!result.problem.empty()) outputs.refused.emplace_back(result.polygon, result.problem);
}

}  // namespace

namespace {

// Averages over objects of several weights would say nothing: the loads of each count as those of the
// thesis's object, bit for bit if its weight is that.
std::vector<PolygonResult> of_thesis_weight(std::vector<PolygonResult> results) {
  for (PolygonResult& result : results)
    for (Measurement& m : result.measurements) {
      const double weight = m.load_mean * m.robots;
      if (std::abs(weight - experiment_weight) <= tau * experiment_weight) continue;
      for (double* load : {&m.load_min, &m.load_mean, &m.load_max, &m.spread})
        *load *= experiment_weight / weight;
    }
  return results;
}

}  // namespace

Outputs make_outputs(const std::vector<ResultSet>& sets) {
  std::vector<SetAggregates> aggregates;
  std::vector<std::vector<Figure>> figures;
  Outputs outputs;
  for (const ResultSet& set : sets) {
    const std::vector<PolygonResult> scaled = of_thesis_weight(set.results);
    aggregates.push_back({set.name, aggregate(scaled)});
    figures.push_back(make_figures(aggregates.back()));
    outputs.claims.push_back({set.name, make_claims(scaled, aggregates.back().aggregates)});
    outputs.few_robots.push_back(few_robots(aggregates.back()));
    for (const PolygonResult& result : set.results) add_refused(result, outputs);
  }
  outputs.measurements_csv = measurements_csv(sets);
  outputs.aggregates_csv = aggregates_csv(aggregates);
  outputs.polygons_csv = polygons_csv(sets);
  outputs.figures = by_figure(std::move(figures));
  return outputs;
}

Outputs make_polygon_outputs(const PolygonResult& result, const ExperimentSettings& settings) {
  const std::vector<ResultSet> alone = {{result.set, {result}}};
  Outputs outputs;
  outputs.measurements_csv = measurements_csv(alone);
  outputs.polygons_csv = polygons_csv(alone);
  outputs.figures = make_polygon_figures(result, settings);
  add_refused(result, outputs);
  return outputs;
}

std::string outputs_json(const Outputs& outputs) {
  std::vector<std::string> refused;
  for (const auto& [polygon, problem] : outputs.refused)
    refused.push_back(
        json::object({{"polygon", json::text(polygon)}, {"problem", json::text(problem)}}));
  return json::object({{"measurements", json::text(outputs.measurements_csv)},
                       {"aggregates", json::text(outputs.aggregates_csv)},
                       {"polygons", json::text(outputs.polygons_csv)},
                       {"thesis", json::text(claims_markdown(outputs.claims))},
                       {"refused", json::array(refused)},
                       {"figures", figures_json(outputs.figures)},
                       {"claims", claims_json(outputs.claims)},
                       {"few_robots", few_robots_json(outputs.few_robots)}});
}

}  // namespace evenlift::experiment
