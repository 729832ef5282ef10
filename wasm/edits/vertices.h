// Changes of robots, vertices, weights, drawn shapes, and of the picture behind them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "evenlift/plane.h"
#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// --- Robots that the user places by hand (the method `given`).

// Returns `settings` with the method `given`, and with the placement's robots as supports at their
// present places, whichever method placed them.
Settings taken_over(Settings settings, const Placement& placement);

// Whether a dragged robot becomes a support, because it can neither move along a range nor keep all
// robots balanced.
bool stands_freely(const Placement& placement);

// Moves a support (Placement::support_of()) to the place from support_spot() (tools/drawing.h).
// Robots of another method are taken over first, and a notice offers the way back. A robot that is
// dragged out of the object carries nothing (Misfitting in placement.h), and is taken away if it is
// let go there; the only robot, and one in a challenge that is not a task or with readings, stays
// where it last could stand. A support that was outside already may be dragged anywhere. O(m + n),
// plus a placement.
void move_support(AppState& state, std::size_t support, const Vec2& to);

// Takes away the support that was dragged out of the object, if there is one.
void take_away_dragged_out(AppState& state);

// Puts robots beneath the object for the user to move, where supports_to_place()
// (evenlift/supports.h) finds places. This is one step of undo.
inline constexpr std::size_t usual_robots_to_place = 4;
void place_yourself(AppState& state, std::size_t robots = usual_robots_to_place);

// The robots' places as supports (for robots with a size, their contacts); empty if there are none,
// or if the document is refused. O(robots).
Points supports_now(const AppState& state);

// Puts a robot exactly at a place, as one step of undo. Does nothing if no robot can stand there.
void put_support(AppState& state, std::size_t robot, const Vec2& at);
// Names a robot; "" takes its name away. The name must be valid (settings.h).
void name_support(AppState& state, std::size_t robot, const std::string& name);

// add_support() adds a robot at a place or, without a place, where the robot adds most to the
// lifting base. remove_support() removes a robot or, without a number, the last one.
// even_out_supports() moves two or three robots so that all carry the same load. Each is one step
// of undo.
void add_support(AppState& state, std::optional<Vec2> at);
void remove_support(AppState& state, std::optional<std::size_t> robot);
void even_out_supports(AppState& state);

// Robots placed by hand belong to the object: after an edit of its outline or holes, moves those on
// the edges of `before` along, each with its part of its edge. Others stay where they are, even if
// they are then outside. Does nothing for other methods. O(m n) for m robots.
void carry_supports(Document& document, const PolygonGrip& before);

// --- Moves of robots by hand.

// Moves a robot of the first picture. A balanced robot moves to the point of the outline nearest to
// `to`, and its two neighbours move so that all loads stay equal. A team's robot moves along its
// range towards `to`. If the other robots cannot follow, no robot moves. If the pointer holds the
// robot, the state then notes where the robot should go (View::closed_to); otherwise a notice
// appears. O(n log n).
void move_robot(AppState& state, std::size_t robot, const Vec2& to);

// Moves all robots back to their original places, as one step of undo. Does nothing if no robot was
// moved.
void put_robots_back(AppState& state);

// Moves teams back to their original places, where the walkthrough shows them. Does not move
// balanced robots.
void put_teams_back(AppState& state);

// --- Moves, adds and removes weights, and vertices of the outline and of holes. The parameters
// `number` and `edge` are numbers of handles (handles.h).

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

// Takes up the drawing that was left (can_go_on_drawing() of tools/drawing.h).
void go_on_drawing(AppState& state);

// Closes the drawn shape: opens the polygon with the settings that opened_after() (state/derived.h)
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
