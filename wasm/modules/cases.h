// The table of all cases of loading (evenlift/cases.h), for paper.
#pragma once

#include <string>

#include "evenlift/cases.h"
#include "evenlift/report.h"

namespace evenlift::view {

// Whether there are robots, and no more than are printed on a page. O(teams).
bool cases_fit_on_paper(const Placement& placement);

// {"headings", "rows", "worst"}: the table's texts and the index of the worst row. It costs
// load_cases().
std::string table_of_cases(const Reported& of);

}  // namespace evenlift::view
