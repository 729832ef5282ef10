// The brush that marks no-go parts.
#pragma once

#include <cstdint>
#include <optional>

#include "state/state.h"

namespace evenlift::view {

inline constexpr double brush_reach = 12, finger_reach = 22;  // pixels

// The outline's nearest edge within the brush's reach, and the nearest place on this edge: 0 at its
// start, 1 at its end. brushed_place() returns nothing if no edge is within reach. O(n).
struct BrushedPlace {
  std::uint32_t edge;
  double at;
};
std::optional<BrushedPlace> brushed_place(const AppState& state, const Vec2& screen, bool finger);

// Returns the settings after a stroke of the brush from one place on the screen to another. The
// stroke marks or erases everything within the brush's reach, except where there would be more than
// `most_no_go` parts. O(n), and O(parts) for each edge that the stroke meets.
Settings brushed(const AppState& state, const Vec2& from, const Vec2& to, bool finger);

// Returns the settings after a click of the brush on an edge: the whole edge becomes a no-go edge
// or, if the brush erases, loses its no-go parts. The limit `most_no_go` applies here too.
Settings with_whole_edge(const AppState& state, std::uint32_t edge);

}  // namespace evenlift::view
