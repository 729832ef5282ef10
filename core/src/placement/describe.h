// Completes a placement, and moves its robots.
#pragma once

#include "evenlift/placement.h"

namespace evenlift {

// Computes all values that follow from the teams, such as loads and coverage. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots as with_moved() (moved.h) does, or returns an error that says why they cannot stand
// there. O(n log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

}  // namespace evenlift
