// Who bears what, failures and doubt about C, for people: the parts of what `place` prints.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/doubt.h"
#include "evenlift/load_models.h"
#include "evenlift/placed_robots.h"
#include "input/command_line.h"

namespace evenlift::native {

// What was typed of it.
struct RobustnessOptions {
  std::optional<std::string> loads;
  bool failures = false;

  void declare(CommandLine& line);
};

// The values of these options, and what the document says of doubt. Throws Failure naming the
// option where they are none.
struct RobustnessAsked {
  RobustnessAsked(const RobustnessOptions& options, const Shown& shown);

  LoadModel model = LoadModel::plan;
  double com_radius = 0;
  bool failures = false;
};

// What is known of a placement's robots beyond its own numbers, as far as it was asked for.
struct RobustnessKnown {
  RobustnessKnown(const Placement& placement, const RobustnessAsked& wanted);

  RobustnessAsked asked;
  Robustness robustness;
  std::optional<ModelLoads> models;
  std::vector<std::optional<RestOfRobots>> failures;
};

// What the table shows of each robot.
struct ShownLoads {
  std::string heading;
  std::vector<std::string> text;  // ranges if there is doubt about C, else one number
  std::vector<double> greatest;   // of the range, or the number itself
  std::vector<LoadRange> ranges;
};
ShownLoads shown_loads(const Placement& placement, const RobustnessKnown& known);

// The sentences about loads, doubt and failures that were asked for, a line for each.
std::string robustness_lines(const RobustnessKnown& known, const std::optional<double>& capacity,
                             const Units& units);

// What happens if one robot fails, a row for each; empty if that was not asked for.
std::string failure_table(const Placement& placement, const RobustnessKnown& known,
                          const std::optional<double>& capacity);

}  // namespace evenlift::native
