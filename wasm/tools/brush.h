// The brush that marks no-go parts.
#pragma once

#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

inline constexpr double brush_reach = 12, finger_reach = 22;  // pixels

// The outline's nearest edge within the brush's reach, and the nearest place on the edge, from 0 to
// 1. brushed_place() returns nothing if no edge is within reach. O(n).
struct BrushedPlace {
  std::uint32_t edge;
  double at;
};
std::optional<BrushedPlace> brushed_place(const AppState& state, const Vec2& screen, bool finger);

// Returns the settings after a stroke of the brush from one place on the screen to another. The
// stroke marks or erases everything within the brush's reach. O(n), and O(parts) for each edge that
// the stroke meets.
Settings brushed(const AppState& state, const Vec2& from, const Vec2& to, bool finger);

// Returns the settings after a click of the brush on an edge. The whole edge becomes a no-go edge,
// or, if the brush erases, no part of the edge remains one.
Settings with_whole_edge(const AppState& state, std::uint32_t edge);

}  // namespace evenlift::view
