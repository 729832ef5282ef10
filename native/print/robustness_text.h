// The loads, failures and C uncertainty in the output of `place`.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/load_models.h"
#include "evenlift/placed_robots.h"
#include "evenlift/uncertainty.h"
#include "input/command_line.h"

namespace evenlift::native {

struct RobustnessOptions {
  std::optional<std::string> loads;
  bool failures = false;

  void declare(CommandLine& line);
};

// The values of the options, and the disturbance of the document (uncertainty.h). The constructor
// throws Failure with the option's name if a value is invalid, or if there is a disturbance but the
// load model gives no ranges of loads.
struct RobustnessAsked {
  RobustnessAsked(const RobustnessOptions& options, const Shown& shown);

  LoadModel model = LoadModel::plan;
  Disturbance disturbance;
  bool failures = false;
};

// The results for a placement, as far as requested.
struct RobustnessKnown {
  RobustnessKnown(const Placement& placement, const RobustnessAsked& wanted);

  RobustnessAsked asked;
  Robustness robustness;
  std::optional<ModelLoads> models;
  std::vector<std::optional<RestOfRobots>> failures;
};

struct ShownLoads {
  std::string heading;
  std::vector<std::string> text;  // ranges if there is a disturbance, otherwise numbers
  std::vector<double> greatest;   // the upper end of each range, or the number
  std::vector<LoadRange> ranges;
  std::string overloaded;  // the heading above the robots that are overloaded, or can be
};
ShownLoads loads_for_table(const ShownPlacement& of, const RobustnessKnown& known);

// Sentences about the loads, the disturbance, slopes, a further load and failures, as far as
// requested, with a line for each subject. The text is empty if the robots carry no loads.
std::string robustness_lines(const ShownPlacement& of, const RobustnessKnown& known);

// A table with a row for the failure of each robot; empty if failures are not requested.
std::string failure_table(const ShownPlacement& of, const RobustnessKnown& known);

}  // namespace evenlift::native
