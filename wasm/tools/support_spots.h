// A robot placed by hand sticks to vertices and edges near the pointer, and to the place that is
// exactly even with another robot.
#pragma once

#include <cstddef>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

// In pixels.
inline constexpr double edge_reach = 12, even_reach = 8;

// For a robot held at `to`; nothing outside the object. `robot` is its number in the placement, or
// none for a new robot. O(n + m).
std::optional<Vec2> support_spot(const AppState& state, const Vec2& to,
                                 std::optional<std::size_t> robot);

// The nearest even place: straight across C from another robot, as far away, and not outside the
// object. Nothing if none is near. O(n + m).
std::optional<Vec2> even_spot(const AppState& state, const Vec2& to,
                              std::optional<std::size_t> robot, double reach);

// Whether the pointer holds a robot placed by hand.
bool holds_support(const AppState& state);

}  // namespace evenlift::view
