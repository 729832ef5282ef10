// The polygon that is being drawn: which of its edges cross, and which click closes it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

// A click this near to the first vertex, in CSS pixels, closes the polygon.
inline constexpr double closing_reach = 14;

// Whether a press at `screen` would close the polygon. O(1).
bool closes(const AppState& state, const Vec2& screen);

// Where the next vertex goes when the pointer is at `world`: snapped as asked for. O(1).
Vec2 next_point(const AppState& state, const Vec2& world);

// `to` after snapping. The axes go through the neighbours `before` and `after`. O(1).
Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after);

// The pairs of edges of the open chain that cross, touch or overlap; neighbours may share their
// common point. Edge i runs from point i to point i + 1. Exact. O(n²); nothing is searched among
// more than 1,000 points.
std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain);

// The polygon being drawn as text to be kept, one vertex in each line; and back. Nothing if the
// text cannot be read.
std::string drawing_text(const Drawing& drawing);
std::optional<Points> read_drawing(std::string_view text);

}  // namespace evenlift::view
