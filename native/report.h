// The report of an experiment as one HTML file: the thesis's figures redrawn, and the table against
// its text. Needs no network.
#pragma once

#include <string>
#include <vector>

#include "evenlift/experiment/claims.h"
#include "evenlift/experiment/figures.h"

namespace evenlift::native {

// The same bytes for the same data. Where the program was built without what draws charts, the
// report says so and has their numbers as tables.
std::string report_html(const std::vector<experiment::ResultSet>& sets,
                        const std::vector<experiment::Figure>& figures,
                        const std::vector<experiment::SetClaims>& claims,
                        const experiment::ExperimentSettings& settings);

}  // namespace evenlift::native
