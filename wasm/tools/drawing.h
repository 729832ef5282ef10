// Tools: drawing a shape, the brush, ways along the outline, and places for robots.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "evenlift/placement.h"
#include "state/state.h"

namespace evenlift::view {

// --- The polygon or the hole being drawn: its points and edges, and the click that closes it.

// The distance from the first vertex within which a press closes the polygon, in pixels.
inline constexpr double closing_reach = 14;

// Returns whether a press would close the polygon. O(1).
bool closes(const AppState& state, const Vec2& screen);

// Returns the index of the placed vertex that a press grabs: the nearest one within reach; nothing
// if none is within reach. O(n).
std::optional<std::size_t> placed_at(const AppState& state, const Vec2& screen);

// The length and direction of an edge from a placed vertex to the next.
struct Edge {
  double length = 0;
  double degrees = 0;  // counter-clockwise from the x axis, in (-180, 180]
};
Edge edge_between(const Vec2& from, const Vec2& to);

// Return an edge as "120 long · 45.0°", and a length as "120". The scale of the view decides the
// number of decimals of a length. O(1).
std::string edge_in_words(const AppState& state, const Vec2& from, const Vec2& to);
std::string length_in_words(const AppState& state, double length);

// Returns the end of the next edge. Its length and angle are as typed or, if not typed, those of an
// edge to `wanted`. Coordinates are rounded to a millionth of the least power of ten that is at
// least the edge's length. Precondition: at least one vertex is placed. O(1).
Vec2 typed_end(const Drawing& drawing, const Vec2& wanted);

// Returns the centroid of the area that the closed chain encloses; nothing if this area is 0. O(n).
std::optional<Vec2> centroid_of(const Points& chain);

// Returns the point that a press places if the pointer is at `world`: the typed edge's end, or the
// pointer's place after snapping. O(1).
Vec2 next_point(const AppState& state, const Vec2& world);

// Returns the nearest dot of the grid, if points snap to the grid; otherwise `to`, rounded by
// rounded_to_pixels(). O(1).
Vec2 snapped(const AppState& state, const Vec2& to);

// Returns `to` snapped as above. If points snap to the axes, `to` also snaps to the horizontals and
// verticals through the neighbours `before` and `after`, if these lines are near. O(1).
Vec2 snapped(const AppState& state, const Vec2& to, const Vec2& before, const Vec2& after);

// Returns the pairs of edges of the chain that cross, touch or overlap; neighbouring edges may
// share their common point. Edge i begins at point i. The result is exact, but never pairs the
// first and last edges of a closed chain, and is empty for more than 1,000 points. O(n²).
std::vector<std::pair<std::size_t, std::size_t>> crossings(const Points& chain);

// The drawing, kept as text for storage. drawing_text() writes the text; read_drawing() reads it,
// and returns nothing if the text is invalid. The text has one line for each vertex; the text of a
// hole begins with the line "hole".
struct KeptDrawing {
  Points points;
  bool is_hole = false;
};
std::string drawing_text(const Drawing& drawing, bool is_hole);
std::optional<KeptDrawing> read_drawing(std::string_view text);

// --- The brush that marks no-go parts.

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

// --- Finds paths along a polygon's outline, and tells why a robot cannot go to a place.

// Returns the shorter path along the outline from one place to another, both included. O(n).
Points shorter_way(const Points& vertices, const LiftingPoint& from, const LiftingPoint& to);

// Returns why a robot moved by hand cannot go to a place: "Robot 3 cannot go there: …". O(1).
std::string closed_in_words(const Placement& placement, std::size_t robot);

// --- Finds the places to which a robot placed by hand sticks: vertices and edges near the pointer, and
// places that are even with another robot (see even_spot()).

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

// Whether the next undo takes up a drawing that another tool or drawing replaced: if it had two points
// or more, and the object was not edited since. O(1).
bool can_go_on_drawing(const AppState& state);

}  // namespace evenlift::view
