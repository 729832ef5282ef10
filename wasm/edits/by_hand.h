// Robots that the user places by hand (the method `given`).
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// Returns `settings` with the method `given`, and with the placement's robots as supports at their
// present places, whichever method placed them.
Settings taken_over(Settings settings, const Placement& placement);

// Whether a dragged robot becomes a support, because it can neither move along a range nor keep all
// robots balanced.
bool stands_freely(const Placement& placement);

// Moves a robot to the place from support_spot() (tools/drawing.h). Robots of another method
// are taken over first, and a notice offers the way back. A robot that is dragged out of the object
// is removed until it returns, unless it is the only robot. In a challenge that is not a task, the
// robot stays where it last could stand. O(m + n), plus a placement.
void move_support(AppState& state, std::size_t robot, const Vec2& to);

// Puts robots beneath the object for the user to move, where supports_to_place()
// (evenlift/supports.h) finds places. This is one step of undo.
inline constexpr std::size_t usual_robots_to_place = 4;
void place_yourself(AppState& state, std::size_t robots = usual_robots_to_place);

// The robots' places as supports (for robots with a size, their contacts); empty if there are none,
// or if the document is refused. O(robots).
Points supports_now(const AppState& state);

// Puts a robot exactly at a place, as one step of undo. Does nothing if no robot can stand there.
void put_support(AppState& state, std::size_t robot, const Vec2& at);

// add_support() adds a robot at a place or, without a place, where the robot adds most to the
// lifting base. remove_support() removes a robot or, without a number, the last one.
// even_out_supports() moves two or three robots so that all carry the same load. Each is one step
// of undo.
void add_support(AppState& state, std::optional<Vec2> at);
void remove_support(AppState& state, std::optional<std::size_t> robot);
void even_out_supports(AppState& state);

// --- Moves of robots by hand.

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
