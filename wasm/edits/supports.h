// Robots that the user places by hand (the method `given`).
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// The settings with the method `given` and with the robots of the placement, by whatever method, at
// the places that they have now.
Settings taken_over(Settings settings, const Placement& placement);

// Whether a robot of the placement stands freely: neither its range nor the balance of all robots
// can follow it. Then it is dragged as a support.
bool stands_freely(const Placement& placement);

// Moves a robot towards `to`, to the place where support_spot() (tools/support_spots.h) puts it.
// Robots of another method are taken over first, and a notice offers the way back. Outside the
// object the robot is taken away, until it returns; the last robot stays. O(m + n), plus a placement.
void move_support(AppState& state, std::size_t robot, const Vec2& to);

// Puts robots beneath the object for the user to move (supports_to_place() of supports.h), with one
// step of undo.
inline constexpr std::size_t usual_robots_to_place = 4;
void place_yourself(AppState& state, std::size_t robots = usual_robots_to_place);

// The places of the robots as supports (for robots with a size, their contacts); empty without a
// placement. O(robots).
Points supports_now(const AppState& state);

// Puts a robot exactly at a place; nothing happens outside the object. One step of undo.
void put_support(AppState& state, std::size_t robot, const Vec2& at);

// Adds a robot at a place, or where it adds most to the lifting base; removes one, or the last; and
// moves two or three robots so that all carry the same load. Each is one step of undo.
void add_support(AppState& state, std::optional<Vec2> at);
void remove_support(AppState& state, std::optional<std::size_t> robot);
void even_out_supports(AppState& state);

}  // namespace evenlift::view
