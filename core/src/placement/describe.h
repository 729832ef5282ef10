// Computes the values that follow from the positions of the robots.
#pragma once

#include "evenlift/placement.h"

namespace evenlift {

// Fills in all values of a placement that follow from its teams. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots like with_moved() (moved.h), or returns the reason why they cannot stand there. O(n
// log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

}  // namespace evenlift
