// Paths along a polygon's outline, and why a robot cannot take one.
#pragma once

#include <cstddef>
#include <string>

#include "evenlift/placement.h"

namespace evenlift::view {

// Both places are included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

// For a robot moved by hand: "Robot 3 cannot go there: …". O(1).
std::string closed_in_words(const Placement& placement, std::size_t robot);

}  // namespace evenlift::view
