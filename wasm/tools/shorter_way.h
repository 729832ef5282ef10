// Finds paths along a polygon's outline, and tells why a robot cannot go to a place.
#pragma once

#include <cstddef>
#include <string>

#include "evenlift/placement.h"

namespace evenlift::view {

// Returns the shorter path along the outline from one place to another, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

// Returns why a robot moved by hand cannot go to a place: "Robot 3 cannot go there: …". O(1).
std::string closed_in_words(const Placement& placement, std::size_t robot);

}  // namespace evenlift::view
