// The polygon being drawn: its crossing edges, and the click that closes it.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "state/state.h"

namespace evenlift::view {

// From the first vertex, in pixels.
inline constexpr double closing_reach = 14;

// Whether a press would close the polygon. O(1).
bool closes(const AppState& state, const Vec2& screen);

// The placed vertex that a press grabs. O(n).
std::optional<std::size_t> placed_at(const AppState& state, const Vec2& screen);

// From a placed vertex to the next.
struct Edge {
  double length = 0;
  double degrees = 0;  // counter-clockwise from the x axis, in (-180, 180]
};
Edge edge_between(const Vec2& from, const Vec2& to);

// "120 long · 45.0°", with the view's number of decimals. O(1).
std::string edge_in_words(const AppState& state, const Vec2& from, const Vec2& to);
std::string length_in_words(const AppState& state, double length);

// The next edge's end towards `wanted`, with the typed length and angle, rounded to a millionth of
// the edge. Precondition: at least one vertex is placed. O(1).
Vec2 typed_end(const Drawing& drawing, const Vec2& wanted);

// Of the area that the closed chain encloses; nothing if it encloses none. O(n).
std::optional<Vec2> centroid_of(const Points& chain);

// If the pointer is at `world`, after snapping. O(1).
Vec2 next_point(const AppState& state, const Vec2& world);

// On the grid, if points snap to it, or else rounded to the pixels. O(1).
Vec2 snapped(const AppState& state, const Vec2& to);

// The axes go through the neighbours `before` and `after`. O(1).
Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after);

// The pairs of edges of the open chain that cross, touch or overlap; neighbours may share their
// common point. Edge i begins at point i. Exact. O(n²); always empty for more than 1,000 points.
std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain);

// The drawing as text for storage, one vertex per line, and back. A hole begins with a line of its
// own. Nothing if the text cannot be read.
struct KeptDrawing {
  Points points;
  bool is_hole = false;
};
std::string drawing_text(const Drawing& drawing, bool is_hole);
std::optional<KeptDrawing> read_drawing(std::string_view text);

}  // namespace evenlift::view
