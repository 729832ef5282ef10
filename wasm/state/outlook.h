// What the robots of a placement bear as it is shown, and what may go wrong with them; and a robot that
// fails. edits/outlook.h computes it.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"

namespace evenlift::view {

// Robots are counted from 0, team after team.
struct Outlook {
  std::vector<LoadRange> loads;  // of each robot, by `model`
  LoadModel model = LoadModel::plan;
  double greatest = 0;    // of these loads
  Robustness robustness;  // see placed_robots.h
  std::optional<ModelLoads>
      models;  // only if another model than the plan is shown, or a doubt about C
};

// A robot that fails, and the placement as it is then.
struct Failure {
  std::size_t robot = 0;
  std::optional<RestOfRobots> rest;  // none if the others do not carry the object
  Placement placement;               // with_failure() of placed_robots.h
  Outlook outlook;                   // the loads and the robustness of the others
};

}  // namespace evenlift::view
