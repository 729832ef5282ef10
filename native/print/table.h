// Tables, among them the loads and failures of `place`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/cases.h"
#include "evenlift/report.h"
#include "input/command_line.h"

namespace evenlift::native {

using Row = std::vector<std::string>;

// Returns a table with right-aligned columns, two spaces apart and as wide as necessary. The first
// row, which must exist, has the headings. Other rows may have fewer cells. The remark with the
// index of a row, if any, follows the last cell of that row.
std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks = {});

// --- The loads, failures and C uncertainty in the output of `place`.

struct RobustnessOptions {
  std::optional<std::string> loads;
  bool failures = false;

  void declare(CommandLine& line);
};

// What these options ask for. Throws Failure with the option's name if a value is invalid, or if
// there are conditions but the load model gives no ranges of loads.
Asked asked_by(const RobustnessOptions& options, const Shown& shown);

// The loads that the report shows.
struct LoadColumn {
  std::string heading;
  std::vector<std::string> text;  // ranges if there are conditions, otherwise numbers
  std::string overloaded;         // the heading above the robots that are overloaded, or can be
};
LoadColumn load_column(const Reported& of);

// Sentences about the loads, the given conditions, slopes, a further load and failures, as far as
// the report has them, with a line for each subject. The text is empty if the robots carry no loads.
std::string robustness_lines(const Reported& of);

// A table with a row for each case of loading; the worst is marked.
std::string case_table(const Reported& of, const std::vector<LoadCase>& cases);

// A table with a row for the failure of each robot; empty if the report has none.
std::string failure_table(const Reported& of);

}  // namespace evenlift::native
