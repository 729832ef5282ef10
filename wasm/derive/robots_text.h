// Texts that pass robots between the page and the search for balanced robots, bit for bit. Each
// robot is the number of an edge and two coordinates, separated by spaces. The text of a plan for
// failures is the number of robots and the greatest load of a robot or, if no plan was found, only
// the greatest number of robots tried.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/chords.h"
#include "evenlift/polygon.h"

namespace evenlift::view {

std::string robots_text(const std::vector<LiftingPoint>& robots);

// Reads robots. Returns nullopt unless the text has this form and exactly `number` robots, each on
// an edge of the polygon. O(bytes).
std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon);

std::string plan_text(const FailurePlan& plan);

// Reads a plan. Returns nullopt if the text has another form. O(bytes).
std::optional<FailurePlan> read_plan(std::string_view text);

}  // namespace evenlift::view
