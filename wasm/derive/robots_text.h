// Robots as text, bit for bit, between the page and the search for balanced robots: an edge and two
// coordinates for each robot, all separated by spaces. Also the text of a plan for failures: the
// number of robots and the greatest load of one of them, or only the number of robots tried.
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

// The robots; nothing if there are not exactly `number` of them, if one is not on an edge of the
// polygon, or if the text has another form. O(bytes).
std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon);

std::string plan_text(const FailurePlan& plan);

// Nothing if the text has another form. O(bytes).
std::optional<FailurePlan> read_plan(std::string_view text);

}  // namespace evenlift::view
