// Moves of robots by hand.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Moves a robot of the first picture. A balanced robot moves to the point of the outline nearest to
// `to`, and its two neighbours move so that all loads stay equal. A team's robot moves along its
// range towards `to`. If the other robots cannot follow, no robot moves. If the pointer holds the
// robot, the state then notes where the robot should go (View::closed_to); otherwise a notice
// appears. O(n log n).
void move_robot(AppState& state, std::size_t robot, const Vec2& to);

// Moves all robots back to their original places, as one step of undo. Does nothing if no robot was
// moved.
void put_robots_back(AppState& state);

// Moves teams back to their original places, where the walkthrough shows them. Does not move
// balanced robots.
void put_teams_back(AppState& state);

}  // namespace evenlift::view
