// Writes loads and robustness for a placement's JSON, at nesting level `depth`. uncertainty.h
// defines disturbances.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/accuracy.h"
#include "evenlift/extra_load.h"
#include "evenlift/placed_robots.h"
#include "evenlift/tilt.h"

namespace evenlift::json {

std::string robots(const Placement& placement, int depth);

std::string models(const std::optional<ModelLoads>& models, int depth);

std::string ranges(const std::vector<LoadRange>& ranges);

// Includes the ranges of the loads if there is a disturbance.
std::string robustness(const ShownPlacement& of, const std::optional<ModelLoads>& models,
                       int depth);

// If there is a disturbance, includes for each failure RestOfRobots::stays, and the greatest load
// within the disturbance. `overloads` is empty if the robots have no capacity.
std::string failures(const std::vector<std::optional<RestOfRobots>>& failures,
                     const std::vector<bool>& overloads, bool with_disturbance, int depth);

std::string accuracy(const Accuracy& accuracy, int depth);
std::string tilt(const std::optional<Tilt>& tilt, int depth);
std::string extra(const std::optional<ExtraLoad>& extra, double weight, int depth);

}  // namespace evenlift::json
