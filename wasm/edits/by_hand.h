// Moves of robots by hand.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Moves a robot of the first picture. A balanced robot moves to the point of the outline nearest to
// `to`, and its two neighbours move so that all loads stay equal. A team's robot moves along its
// range towards `to`. If the other robots cannot follow, none moves: the state notes where a held
// robot should go, or a notice appears if keys moved it. O(n log n).
void move_robot(AppState& state, std::size_t robot, const Vec2& to);

// Moves all robots back to their original places: one step of undo, unless none was moved.
void put_robots_back(AppState& state);

// Moves teams back, but not balanced robots: a lesson's steps show teams at their original places.
void put_teams_back(AppState& state);

}  // namespace evenlift::view
