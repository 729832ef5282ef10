// The part of the outline along which a balanced robot cannot be dragged on.
#pragma once

#include "evenlift/placement.h"

namespace evenlift::view {

// The shorter way along the outline between two places of it, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

}  // namespace evenlift::view
