// Robots that somebody moves by hand.
#pragma once

#include <cstddef>

#include "state/state.h"

namespace evenlift::view {

// Moves a robot of the first picture: a balanced one to the point of the outline that is nearest to
// `to`, and its two neighbours so that all still bear the same; one of a team along its range
// towards `to`. Where others cannot follow it, the state notes where the robot is wanted that is
// held, and a notice tells it of one that is moved by keys. O(n log n).
void move_robot(AppState& state, std::size_t robot, const Vec2& to);

// Back to where they were found: one step of undo, unless no robot was moved.
void put_robots_back(AppState& state);

// The same for teams only: the steps of a lesson are those of teams where they were found.
void put_teams_back(AppState& state);

}  // namespace evenlift::view
