// An experiment's report as one HTML file, which works without a network. It contains the thesis's
// figures redrawn, results for few robots, and a table of the thesis's claims with our results.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/outputs.h"

namespace evenlift::native {

// Returns the report. The same data gives the same bytes. If the program was built without charts,
// the report has tables and a notice instead of charts.
std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const experiment::Outputs& outputs,
                        const experiment::ExperimentSettings& settings);

}  // namespace evenlift::native
