// Finds the places to which a robot placed by hand sticks: vertices and edges near the pointer, and
// places that are even with another robot (see even_spot()).
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// The distances within which a robot sticks to vertices and edges, and to an even place, in pixels.
inline constexpr double edge_reach = 12, even_reach = 8;

// Returns the place for a robot held at `to`; nothing if `to` is outside the object, and no edge or
// even place is near. `robot` is the robot's number in the placement, or nothing for a new robot.
// O(n + m) for m robots.
std::optional<Vec2> support_spot(const AppState& state, const Vec2& to,
                                 std::optional<std::size_t> robot);

// Returns the nearest even place: straight across C from another robot, equally far from C, and not
// outside the object. Nothing if all even places are farther away than `reach` (pixels). O(n + m).
std::optional<Vec2> even_spot(const AppState& state, const Vec2& to,
                              std::optional<std::size_t> robot, double reach);

// Returns whether the pointer drags a robot placed by hand.
bool holds_support(const AppState& state);

}  // namespace evenlift::view
