// The polygon that is being drawn: which of its edges cross, and what closes it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

// CSS pixels about the first vertex within which a click closes the polygon.
inline constexpr double closing_reach = 14;

// Whether a press at `screen` would close the polygon. O(1).
bool closes(const AppState& state, const Vec2& screen);

// Where the next vertex goes for a pointer at `world`: on a dot, or level with or upright above the
// vertex before, as asked for. O(1).
Vec2 next_point(const AppState& state, const Vec2& world);

// `to`, as far as snapping asks for it; axes through the neighbours `before` and `after`. O(1).
Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after);

// The pairs of edges of the open chain that have more in common than they should: neighbours their
// end, others nothing. Edge i runs from point i to point i + 1. Exact; O(n²), and none are looked
// for among more than 1,000 points.
std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain);

// The polygon being drawn as text, a vertex a line, to be kept; and from it. Nothing if it is not
// that.
std::string drawing_text(const Drawing& drawing);
std::optional<Points> read_drawing(std::string_view text);

}  // namespace evenlift::view
