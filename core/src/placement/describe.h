// Computes the values that follow from the robots' positions.
#pragma once

#include "evenlift/placement.h"

namespace evenlift {

// Fills in all values that follow from the teams. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots like with_moved() (moved.h), or returns an error that says why they cannot stand
// there. O(n log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

}  // namespace evenlift
