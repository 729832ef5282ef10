// The report of an experiment as one HTML file: the thesis's figures redrawn, what few robots
// achieve, and the table against the thesis's text. Needs no network.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/outputs.h"

namespace evenlift::native {

// The same bytes for the same data. Where the program was built without what draws charts, the
// report says so and has their numbers as tables.
std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const experiment::Outputs& outputs,
                        const experiment::ExperimentSettings& settings);

}  // namespace evenlift::native
