// Ways along the outline of a polygon, and why one is closed to a robot.
#pragma once

#include <cstddef>
#include <string>

#include "evenlift/placement.h"

namespace evenlift::view {

// The shorter way along the outline between two places of it, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

// Why a robot that is moved by hand does not follow: "Robot 3 cannot go there: …". O(1).
std::string closed_in_words(const Placement& placement, std::size_t robot);

}  // namespace evenlift::view
