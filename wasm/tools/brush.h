// The brush that marks no-go parts.
#pragma once

#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

inline constexpr double brush_reach = 12, finger_reach = 22;  // pixels

// The nearest edge within the brush's reach, and the nearest place on it, from 0 to 1. O(n).
struct BrushedPlace {
  std::uint32_t edge;
  double at;
};
std::optional<BrushedPlace> brushed_place(const AppState& state, const Vec2& screen, bool finger);

// Marks or erases everything within the brush's reach from one place on the screen to another.
// O(n), and O(parts) for each edge that it meets.
Settings brushed(const AppState& state, const Vec2& from, const Vec2& to, bool finger);

// After a click: the whole edge becomes a no-go edge, or no part of it is one any more.
Settings with_whole_edge(const AppState& state, std::uint32_t edge);

}  // namespace evenlift::view
