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

// After the placed vertices change: forgets the typed values of the next edge, and whether the
// shape can be closed.
void renew_drawing(AppState& state);

void add_point(AppState& state, const Vec2& at);
void move_point(AppState& state, std::size_t point, const Vec2& to);
void take_point_back(AppState& state);
void put_point_back(AppState& state);
void set_draw_cursor(AppState& state, const SetDrawCursor& cursor);

// Takes over the typed values of the next edge, and moves the cursor to its end.
void type_edge(AppState& state, const TypeEdge& typed);

// Forgets the typed values. The next edge ends at the pointer again or, without one, has not begun.
void withdraw_edge(AppState& state);

// Closes the drawn shape: opens the polygon with the present settings, or adds the hole.
void finish_drawing(AppState& state);

}  // namespace evenlift::view
