// All outputs of an experiment.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evenlift/experiment/claims.h"
#include "evenlift/experiment/few_robots.h"
#include "evenlift/experiment/figures.h"

namespace evenlift::experiment {

struct Outputs {
  std::string measurements_csv, aggregates_csv, polygons_csv;
  std::vector<std::pair<std::string, std::string>> refused;  // polygon and reason
  std::vector<Figure> figures;                               // sorted by figure number, then by set
  std::vector<SetClaims> claims;                             // empty for a single polygon
  std::vector<FewRobots> few_robots;                         // empty for a single polygon
};

// The outputs for sets of polygons. Each set has its own averages, for which the loads of each polygon
// are scaled to the thesis's weight. O(rows).
Outputs make_outputs(const std::vector<ResultSet>& sets);

// The outputs for a single polygon: its measurements and make_polygon_figures(). O(rows).
Outputs make_polygon_outputs(const PolygonResult& result, const ExperimentSettings& settings);

// The outputs as JSON for the page:
// {"measurements", "aggregates", "polygons": the CSV files as strings; "thesis": the table in
// Markdown; "refused": [{"polygon", "problem"}]; "figures", "claims", "few_robots": as
// figures_json, claims_json and few_robots_json}. O(output).
std::string outputs_json(const Outputs& outputs);

}  // namespace evenlift::experiment
