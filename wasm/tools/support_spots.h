// Where a robot goes that the user places by hand: it sticks to vertices and edges near the
// pointer, and to the place that is exactly even with another robot.
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// The reach of vertices and edges, and of even places, in pixels.
inline constexpr double edge_reach = 12, even_reach = 8;

// The place for a robot that the pointer holds at `to`; nothing outside the object. `robot` is its
// number among those of the placement, or none for a new robot. O(n + m).
std::optional<Vec2> support_spot(const AppState& state, const Vec2& to,
                                 std::optional<std::size_t> robot);

// The even place nearest to a held robot: straight across C from another robot, as far away, and
// not outside the object. Nothing if none is near. O(n + m).
std::optional<Vec2> even_spot(const AppState& state, const Vec2& to,
                              std::optional<std::size_t> robot, double reach);

// Whether the pointer holds a robot that stands freely, and the place where it holds the robot
// outside the object.
bool holds_support(const AppState& state);

}  // namespace evenlift::view
