#include "evenlift/experiment/outputs.h"

#include "evenlift/output/json_text.h"

namespace evenlift::experiment {

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

Outputs make_outputs(const std::vector<ResultSet>& sets) {
  std::vector<SetAggregates> aggregates;
  std::vector<std::vector<Figure>> figures;
  Outputs outputs;
  for (const ResultSet& set : sets) {
    aggregates.push_back({set.name, aggregate(set.results)});
    figures.push_back(make_figures(aggregates.back()));
    outputs.claims.push_back({set.name, make_claims(set.results, aggregates.back().aggregates)});
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
