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

// Moves a robot to the place from support_spot() (tools/support_spots.h). Robots of another method
// are taken over first, and a notice offers the way back. A robot dragged out of the object is
// taken away until it returns, except the last one. O(m + n), plus a placement.
void move_support(AppState& state, std::size_t robot, const Vec2& to);

// Puts robots beneath the object for the user to move (supports_to_place() of supports.h). This is
// one step of undo.
inline constexpr std::size_t usual_robots_to_place = 4;
void place_yourself(AppState& state, std::size_t robots = usual_robots_to_place);

// The robots' places as supports (for robots with a size, their contacts); empty without a
// placement. O(robots).
Points supports_now(const AppState& state);

// Puts a robot exactly at a place, as one step of undo. Does nothing if no robot can stand there.
void put_support(AppState& state, std::size_t robot, const Vec2& at);

// The first function adds a robot at a place, or where it adds most to the lifting base. The second
// removes a robot, or the last one. The third moves two or three robots so that all carry the same
// load. Each is one step of undo.
void add_support(AppState& state, std::optional<Vec2> at);
void remove_support(AppState& state, std::optional<std::size_t> robot);
void even_out_supports(AppState& state);

}  // namespace evenlift::view
