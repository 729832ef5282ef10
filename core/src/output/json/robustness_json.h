// The members of a placement's JSON about loads and robustness. `depth` is the nesting level of the
// value.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/placed_robots.h"

namespace evenlift::json {

std::string robots(const Placement& placement, int depth);

std::string models(const std::optional<ModelLoads>& models, int depth);

// With a radius above 0, includes the ranges of the loads while C is anywhere within it.
std::string robustness(const Placement& placement, const std::optional<ModelLoads>& models,
                       double com_radius, int depth);

std::string failures(const std::vector<std::optional<RestOfRobots>>& failures,
                     const std::vector<bool>& overloads, int depth);

}  // namespace evenlift::json
