// All that an experiment says, made of the polygons' results.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "evenlift/experiment/claims.h"
#include "evenlift/experiment/figures.h"

namespace evenlift {

struct Outputs {
  std::string measurements_csv, aggregates_csv, polygons_csv;
  std::vector<std::pair<std::string, std::string>> refused;  // polygon, why it was left out
  std::vector<Figure> figures;
  std::vector<Claim> claims;
};

// `results` by name, as sort_results leaves them. O(rows).
Outputs make_outputs(const std::vector<PolygonResult>& results);

// Sorts by name (bytes), which are all different. O(n log n).
void sort_results(std::vector<PolygonResult>& results);

// {"measurements", "aggregates", "polygons": the CSV files as strings; "thesis": the table in
// Markdown; "refused": [{"polygon", "problem"}]; "figures", "claims": as figures_json and
// claims_json} for the page. O(output).
std::string outputs_json(const Outputs& outputs);

}  // namespace evenlift
