// Draws a polygon vertex by vertex.
#pragma once

#include <cstddef>
#include <optional>

#include "evenlift/plane.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
