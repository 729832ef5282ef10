// Ways along the outline of a polygon.
#pragma once

#include "evenlift/placement.h"

namespace evenlift::view {

// The shorter way along the outline between two places of it, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

}  // namespace evenlift::view
