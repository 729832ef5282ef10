// What follows from where the robots stand.
#pragma once

#include "evenlift/placement.h"

namespace evenlift {

// Fills in everything of a placement that follows from its teams. O(n log n).
void describe_grasp(Placement& placement);

}  // namespace evenlift
