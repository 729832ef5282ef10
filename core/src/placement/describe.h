// What follows from where the robots stand.
#pragma once

#include "evenlift/placement.h"

namespace evenlift {

// Fills in everything of a placement that follows from its teams. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots as with_moved() does (moved.h), or returns why they cannot stand there. O(n log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

}  // namespace evenlift
