#include "evenlift/experiment/figures.h"

#include <algorithm>

#include "evenlift/experiment/algorithm_average.h"
#include "evenlift/output/json_text.h"
#include "experiment/thesis/sentences.h"

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

}  // namespace evenlift::experiment
