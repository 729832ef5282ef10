// Robots as text, from the page to the search for balanced robots and back, bit for bit: for each
// an edge and two coordinates, with spaces between all of them. And how many it takes if any one
// may fail: their number and what one bears at most, or only how many were tried.
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

// The robots; nothing if there are not `number` of them, if one is on no edge of the polygon, or if
// the text is another. O(bytes).
std::optional<std::vector<LiftingPoint>> read_robots(std::string_view text, std::size_t number,
                                                     const Polygon& polygon);

std::string plan_text(const FailurePlan& plan);

// Nothing if the text is another. O(bytes).
std::optional<FailurePlan> read_plan(std::string_view text);

}  // namespace evenlift::view
