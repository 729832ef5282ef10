// The report of an experiment as one HTML file: the thesis's figures redrawn, the results of few
// robots, and the table against the thesis's text. Works without a network.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/outputs.h"

namespace evenlift::native {

// The same data gives the same bytes. If the program was built without charts, the report contains
// a notice and their numbers as tables.
std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const experiment::Outputs& outputs,
                        const experiment::ExperimentSettings& settings);

}  // namespace evenlift::native
