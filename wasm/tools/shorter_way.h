// Paths along the outline of a polygon, and why a robot cannot take one.
#pragma once

#include <cstddef>
#include <string>

#include "evenlift/placement.h"

namespace evenlift::view {

// The shorter path along the outline between two places, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

// Why a robot moved by hand does not follow: "Robot 3 cannot go there: …". O(1).
std::string closed_in_words(const Placement& placement, std::size_t robot);

}  // namespace evenlift::view
