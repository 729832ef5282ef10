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

// A click this near to the first vertex, in pixels, closes the polygon.
inline constexpr double closing_reach = 14;

// Whether a press at `screen` would close the polygon. O(1).
bool closes(const AppState& state, const Vec2& screen);

// The placed vertex at `screen` that a press takes hold of. O(n).
std::optional<std::size_t> placed_at(const AppState& state, const Vec2& screen);

// Where a vertex begins the next edge, if any is placed.
struct Edge {
  double length = 0;
  double degrees = 0;  // counter-clockwise from the x axis, in (-180, 180]
};
Edge edge_between(const Vec2& from, const Vec2& to);

// "120 long · 45.0°", with as many decimals as the view shows. O(1).
std::string edge_in_words(const AppState& state, const Vec2& from, const Vec2& to);
std::string length_in_words(const AppState& state, double length);

// The end of the next edge towards `wanted`, with the length and the angle that were typed. At
// least one vertex is placed. It is rounded to a millionth of the edge. O(1).
Vec2 typed_end(const Drawing& drawing, const Vec2& wanted);

// The centroid of the area that a chain encloses when it is closed; nothing if that is no area.
// O(n).
std::optional<Vec2> centroid_of(const Points& chain);

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
