// Moves, adds and removes weights, and vertices of the outline and of holes. The parameters
// `number` and `edge` are numbers of handles (handles.h).
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/plane.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

void move_handle(AppState& state, std::size_t number, const Vec2& to);

// Inserts a vertex on an edge, and selects it.
void insert_vertex(AppState& state, std::size_t edge, const Vec2& at);

// Removes a vertex or a weight. A hole of three vertices is removed as a whole.
void remove_handle(AppState& state, std::size_t number);

// Adds a weight of about a tenth of the object's own weight, and selects it.
void add_weight(AppState& state, const Vec2& at);

// Records the polygon and everything that moves with it, at the start of a drag. O(n).
void grip_polygon(AppState& state);

// The reason why a weight is refused, as a sentence without a full stop; empty if it is accepted.
// O(bytes).
std::string problem_of(const Cargo& item);

// Replaces one weight, or shows a notice that says why it is refused.
void set_weight(AppState& state, std::size_t item, const Cargo& cargo);

// --- Draws a polygon vertex by vertex.

// Changes the tool, and forgets the drawn points.
void take_tool(AppState& state, Tool tool);

// Forgets the typed values of the next edge, and the result of the check whether the shape can be
// closed. Call it after the placed vertices change.
void renew_drawing(AppState& state);

void add_point(AppState& state, const Vec2& at);
void move_point(AppState& state, std::size_t point, const Vec2& to);
void take_point_back(AppState& state);
void put_point_back(AppState& state);
void set_draw_cursor(AppState& state, const SetDrawCursor& cursor);

// Takes over the typed values of the next edge, and moves the cursor to the edge's end.
void type_edge(AppState& state, const TypeEdge& typed);

// Forgets the typed values of the next edge. The edge then ends at the pointer again; without a
// pointer, it has no length.
void withdraw_edge(AppState& state);

// Closes the drawn shape: opens the polygon with the settings that opened_after() (state/opened.h)
// keeps, or adds the hole. If the shape is refused, shows a notice instead.
void finish_drawing(AppState& state);

// --- The picture behind the drawing.

// Puts a picture with these corners behind the drawing, in place of any other picture. Shows the
// whole picture, and selects the tool that draws a polygon.
void lay_behind(AppState& state, const Vec2& low, const Vec2& high);
void take_picture_away(AppState& state);

// Gives the picture this width; its lower left corner becomes the origin. Also scales the vertices
// being drawn, or the polygon that was drawn on the picture. Scaling the polygon is one step of
// undo. Does nothing if there is no picture. Returns why the width is impossible, or an empty text.
// O(n), plus a placement.
std::string scale_picture(AppState& state, double width);

}  // namespace evenlift::view
