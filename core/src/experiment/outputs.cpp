#include "evenlift/experiment/outputs.h"

#include <algorithm>

#include "../output/json_text.h"

namespace evenlift {

Outputs make_outputs(const std::vector<PolygonResult>& results) {
  const std::vector<Aggregate> aggregates = aggregate(results);
  Outputs outputs{measurements_csv(results), aggregates_csv(aggregates),
                  polygons_csv(results),     {},
                  make_figures(aggregates),  make_claims(results, aggregates)};
  for (const PolygonResult& result : results)
    if (!result.problem.empty()) outputs.refused.emplace_back(result.polygon, result.problem);
  return outputs;
}

void sort_results(std::vector<PolygonResult>& results) {
  std::sort(results.begin(), results.end(),
            [](const PolygonResult& a, const PolygonResult& b) { return a.polygon < b.polygon; });
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
                       {"claims", claims_json(outputs.claims)}});
}

}  // namespace evenlift
