#include "actions/pointer.h"

#include <cmath>

#include "actions/actions.h"
#include "evenlift/stands.h"
#include "state/layout.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "tools/transform.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

void move_cursor(const AppState& s, Commands& out, int x, int y, bool finely) {
  const Drawing& d = s.view.drawing;
  Vec2 at = d.cursor ? *d.cursor
            : !d.points.empty()
                ? d.points.back()
                : nearest_dot(s.view.camera, s.view.camera.to_world(layout(s).free.middle()));
  const bool begins = !d.cursor && d.points.empty();  // the first press shows the cursor
  if (!begins) {
    const double step = finely ? 1 / s.view.camera.scale : grid_step(s.view.camera);
    const Vec2 wanted = at + Vec2(x * step, y * step);
    const Vec2 to =
        finely ? rounded_finely(s.view.camera, wanted) : nearest_dot(s.view.camera, wanted);
    if (x != 0)
      at.x = to.x;
    else
      at.y = to.y;
  }
  out.push_back(SetDrawCursor{at, {}, true});
}

void nudge(const AppState& s, Commands& out, int x, int y) {
  if (when::drawing(s)) return move_cursor(s, out, x, y, false);
  if (when::transforming(s)) return out.push_back(moved_polygon(s, x, y));
  if (when::on_robot(s)) {
    const Vec2 along = Vec2(x, y) * (grid_step(s.view.camera) / 10);
    const std::size_t robot = s.derived().placement->support_of(*s.derived().explanation->robot);
    out.push_back(MoveRobot{robot, s.derived().explanation->of.at + along});
    return out.push_back(EndEdit{});
  }
  const double step = grid_step(s.view.camera) / (s.view.snap.grid ? 1 : 10);
  const Vec2 to = place_of(s.work.document(), *s.view.selected) + Vec2(x * step, y * step);
  out.push_back(MoveVertex{*s.view.selected, snapped(s, to)});
  out.push_back(EndEdit{});
}

namespace {

constexpr double still = 3;  // pixels that a click may move

Vec2 neighbour(const Points& points, std::size_t i, bool next) {
  if (next) return points[i + 1 == points.size() ? 0 : i + 1];
  return points[i == 0 ? points.size() - 1 : i - 1];
}

// Whether the drawing answers for each point: the effect of a load, or the slope at which the
// object tips that way (marks/marks.h).
bool answers_for_points(const AppState& state) {
  const Overlays& overlays = shown(state).overlays;
  return (overlays.load && shown_report(state).extra) ||
         (overlays.tilt && shown(state).carrying.has_height());
}

void press_parts(const AppState& state, const Pointer& pointer, Commands& commands) {
  Pick under = pick_to_hold(state, pointer.at, pointer.second);
  // During a question, a press selects a choice, not a vertex at its end.
  if (under.kind == Pick::Kind::vertex && walkthrough_is_open(state) &&
      choice_at(state, pointer.at))
    under = {};
  if (under.kind == Pick::Kind::edge && pointer.double_pressed && !state.session.screen.embed) {
    const Vec2 at = rounded_to_pixels(state.view.camera, under.at);
    commands.push_back(InsertVertex{under.index, at});
    under = {Pick::Kind::vertex, under.index + 1, 0, at};  // it can be dragged at once
  }
  // A finger cannot hover, so its press also hovers.
  if (pointer.touch) commands.push_back(SetHover{under});
  const bool grip = under.kind == Pick::Kind::vertex || under.kind == Pick::Kind::centre ||
                    under.kind == Pick::Kind::cargo || under.kind == Pick::Kind::uncertainty ||
                    under.kind == Pick::Kind::left_out || can_take_robot(state, under);
  // A finger drags the point in question, where a mouse pans.
  const bool asks = pointer.touch && under.kind == Pick::Kind::object && answers_for_points(state);
  if (!grip && !asks) under.kind = Pick::Kind::ground;
  // `at` becomes the offset from the pointer to the held part, so that nothing jumps.
  under.at = grip ? Vec2(state.view.camera.to_screen(under.at) - pointer.at) : pointer.at;
  commands.push_back(SetHeld{under});
  if (under.kind == Pick::Kind::vertex) commands.push_back(SelectVertex{under.index});
  if (under.kind == Pick::Kind::cargo)
    commands.push_back(SelectVertex{weight_handle(state.work.document(), under.index)});
}

// A press on a robot grabs it; elsewhere a click adds one.
void press_robot(const AppState& state, const Pointer& pointer, Commands& commands) {
  Pick under = left_out_at(state, pointer.at);
  if (under.kind == Pick::Kind::none) under = pick_explained(state, pointer.at, pointer.second);
  if (under.kind == Pick::Kind::left_out || can_take_robot(state, under))
    under.at = state.view.camera.to_screen(under.at) - pointer.at;
  else
    under = {Pick::Kind::ground, 0, 0, pointer.at};
  commands.push_back(SetHeld{under});
}

// The same for a weight.
void press_weight(const AppState& state, const Pointer& pointer, Commands& commands) {
  Pick under = weight_at(state, pointer.at);
  if (under.kind != Pick::Kind::cargo)
    under = {Pick::Kind::ground, 0, 0, pointer.at};
  else
    under.at = state.view.camera.to_screen(under.at) - pointer.at;
  commands.push_back(SetHeld{under});
  if (under.kind == Pick::Kind::cargo)
    commands.push_back(SelectVertex{weight_handle(state.work.document(), under.index)});
}

void press(const AppState& state, const Pointer& pointer, Commands& commands) {
  if (state.view.tool == Tool::parts) return press_parts(state, pointer, commands);
  if (state.view.tool == Tool::robot) return press_robot(state, pointer, commands);
  if (state.view.tool == Tool::weight) return press_weight(state, pointer, commands);
  Pick held{Pick::Kind::ground, 0, 0, pointer.at};
  if (draws(state.view.tool)) {
    if (const auto placed = placed_at(state, pointer.at)) {
      const Vec2 at = state.view.camera.to_screen(state.view.drawing.points[*placed]);
      held = {Pick::Kind::vertex, *placed, 0, at - pointer.at};
    }
  }
  if (state.view.tool == Tool::transform) {
    if (const auto grip = grip_at(state, pointer.at)) {
      held.kind = Pick::Kind::frame;
      held.index = static_cast<std::size_t>(*grip);
      commands.push_back(GripPolygon{});
    }
  }
  if (state.view.tool == Tool::mark) {
    if (const auto place = brushed_place(state, pointer.at, pointer.touch)) {
      held.kind = Pick::Kind::edge;
      held.index = place->edge;
      commands.push_back(SetErases{is_marked(settings(state).no_go, place->edge, place->at)});
    }
  }
  commands.push_back(SetHeld{held});
}

// The brush was last at held.at, in pixels. Off the boundary it marks nothing.
void drag_brush(const AppState& state, const Pointer& pointer, Commands& commands) {
  Pick held = state.view.held;
  const Settings changed = brushed(state, held.at, pointer.at, pointer.touch);
  if (!(changed == settings(state))) commands.push_back(SetSettings{changed, true});
  held.at = pointer.at;
  commands.push_back(SetHeld{held});
}

void drag_ground(const AppState& state, const Pointer& pointer, Commands& commands) {
  const Pick& held = state.view.held;
  // A shaky click still places a vertex or a robot.
  if ((draws(state.view.tool) || adds_by_click(state.view.tool)) && pointer.moved < still) return;
  if (!(length(pointer.at - held.at) > 0)) return;
  commands.push_back(SetCamera{pan(state.view.camera, pointer.at - held.at)});
  Pick moved = held;
  moved.at = pointer.at;
  commands.push_back(SetHeld{moved});
}

// The vertex's neighbours are those in the closed shape.
void drag_placed(const AppState& state, const Pointer& pointer, Commands& commands) {
  const std::size_t i = state.view.held.index;
  const Points& points = state.view.drawing.points;
  if (i >= points.size()) return;
  const Vec2 to = state.view.camera.to_world(pointer.at + state.view.held.at);
  commands.push_back(
      MovePoint{i, snapped(state, to, neighbour(points, i, false), neighbour(points, i, true))});
}

void drag(const AppState& state, const Pointer& pointer, Commands& commands) {
  const Pick& held = state.view.held;
  if (held.kind == Pick::Kind::ground) return drag_ground(state, pointer, commands);
  if (held.kind == Pick::Kind::object) {
    commands.push_back(SetHover{object_at(state, pointer.at, pointer.second)});
    return;
  }
  if (pointer.moved < still && !state.work.edit_open) return;
  if (draws(state.view.tool)) return drag_placed(state, pointer, commands);
  if (state.view.tool == Tool::mark) return drag_brush(state, pointer, commands);
  if (held.kind == Pick::Kind::frame) {
    commands.push_back(
        dragged_polygon(state, static_cast<FrameGrip>(held.index), held.at, pointer.at));
    return;
  }
  const Vec2 to = state.view.camera.to_world(pointer.at + held.at);
  if (held.kind == Pick::Kind::vertex) {
    const Document& document = state.work.document();
    if (held.index < count_vertices(document))
      commands.push_back(MoveVertex{held.index, snapped(state, to, before(document, held.index),
                                                        after(document, held.index))});
  }
  if (held.kind == Pick::Kind::cargo)
    commands.push_back(
        MoveVertex{weight_handle(state.work.document(), held.index), snapped(state, to)});
  if (held.kind == Pick::Kind::uncertainty)
    commands.push_back(showing(state, &Shown::com_radius,
                               uncertainty_for_grip(state, pointer.at + held.at), true));
  if (held.kind == Pick::Kind::robot && state.derived().placement &&
      !state.derived().placement->teams.empty()) {
    const std::size_t in_team = state.derived().placement->teams.front().robots.size();
    const std::size_t robot = held.index * in_team + static_cast<std::size_t>(held.end);
    commands.push_back(MoveRobot{state.derived().placement->support_of(robot), to});
  }
  if (held.kind == Pick::Kind::left_out) commands.push_back(MoveRobot{held.index, to});
  if (held.kind == Pick::Kind::centre) {
    const Vec2 centroid = own_centroid(state).value_or(to);
    const double away =
        length(state.view.camera.to_screen(to) - state.view.camera.to_screen(centroid));
    if (away <= (state.view.snap.grid || state.view.snap.axis ? 12 : 6))
      commands.push_back(MoveCentre{});
    else
      commands.push_back(MoveCentre{snapped(state, to)});
  }
}

void click_drawing(const AppState& state, const Pointer& pointer, Commands& commands) {
  if (closes(state, pointer.at)) {
    commands.push_back(FinishDrawing{});
  } else {
    commands.push_back(AddPoint{next_point(state, state.view.camera.to_world(pointer.at))});
  }
}

// Answers the question, or asks why the chord there was not chosen.
void click_walkthrough(const AppState& state, const Pointer& pointer, Commands& commands) {
  commands.push_back(SelectVertex{});
  if (state.view.walkthrough.ask) {
    if (const auto choice = choice_at(state, pointer.at)) commands.push_back(Guess{*choice});
  } else {
    commands.push_back(AskWhy{state.view.camera.to_world(pointer.at)});
  }
}

void release(const AppState& state, const Pointer& pointer, Commands& commands) {
  // A finger that rested to ask does nothing else when it is lifted.
  const bool asked_by_finger = state.session.screen.touch && state.session.screen.asking;
  const bool still_there = pointer.moved < still && !asked_by_finger;
  const Pick::Kind held = state.view.held.kind;
  const bool clicked = (held == Pick::Kind::ground || held == Pick::Kind::object) && still_there;
  // A click on a vertex, without a drag, also asks about a robot there.
  const bool asks = still_there && state.view.tool == Tool::parts && !walkthrough_is_open(state);
  const Pick asked = asks ? pick_explained(state, pointer.at, pointer.second) : Pick{};
  if (asked.kind != Pick::Kind::none)
    commands.push_back(Explain{asked});
  else if (state.derived().explanation)
    commands.push_back(Explain{});
  if (asked.kind == Pick::Kind::none && clicked && failing(state)) commands.push_back(Fail{});
  if (draws(state.view.tool)) {
    const bool on_placed = still_there && state.view.held.kind == Pick::Kind::vertex;
    if (clicked || (on_placed && closes(state, pointer.at)))
      click_drawing(state, pointer, commands);
  } else if (state.view.tool == Tool::robot) {
    if (clicked) commands.push_back(AddRobot{state.view.camera.to_world(pointer.at)});
  } else if (state.view.tool == Tool::weight) {
    const Vec2 at = state.view.camera.to_world(pointer.at);
    if (clicked) commands.push_back(AddWeight{snapped(state, at)});
  } else if (state.view.tool == Tool::mark && state.view.held.kind == Pick::Kind::edge &&
             still_there)
    commands.push_back(
        SetSettings{with_whole_edge(state, static_cast<std::uint32_t>(state.view.held.index))});
  // A click on the ground, unlike a pan, clears the selection.
  else if (clicked && walkthrough_is_open(state))
    click_walkthrough(state, pointer, commands);
  else if (clicked)
    commands.push_back(SelectVertex{});
  commands.push_back(EndEdit{});
  commands.push_back(SetHeld{});
}

void pinch(const AppState& state, const Pointer& pointer, Commands& commands) {
  // Releases the first finger's part where it is.
  if (state.view.held.kind != Pick::Kind::none) release(state, pointer, commands);
  commands.push_back(SetCamera{pan(state.view.camera, pointer.pinch_moved)});
  commands.push_back(ZoomView{pointer.pinch_factor, pointer.pinch_at});
}

// Over a panel, its rows determine the hovered part (panels.cpp).
void hover_over(const AppState& state, const Pointer& pointer, const Pick& over,
                Commands& commands) {
  const bool over_rows = pointer.over_panel && !pointer.touch;
  if (!over_rows && !(over == state.view.hover)) commands.push_back(SetHover{over});
}

void hover_drawing(const AppState& state, const Pointer& pointer, bool none, Commands& commands) {
  const Drawing& drawing = state.view.drawing;
  // The result of keys or typing stays until the pointer moves over the drawing.
  if (drawing.by_keys && (none || pointer.at == drawing.pointer)) return;
  Pick over;
  std::optional<Vec2> cursor, at;
  if (!none) {
    at = pointer.at;
    const auto placed = placed_at(state, pointer.at);
    if (placed) over = {Pick::Kind::vertex, *placed, 0, drawing.points[*placed]};
    if (closes(state, pointer.at))
      cursor = drawing.points.front();
    else if (!placed)
      cursor = next_point(state, state.view.camera.to_world(pointer.at));
  }
  hover_over(state, pointer, over, commands);
  if (cursor != drawing.cursor || at != drawing.pointer)
    commands.push_back(SetDrawCursor{cursor, at});
}

void hover(const AppState& state, const Pointer& pointer, Commands& commands) {
  const bool none = !pointer.present || pointer.over_panel;
  if (draws(state.view.tool)) return hover_drawing(state, pointer, none || pointer.touch, commands);
  // A part that a finger pressed stays hovered until the finger presses another.
  if (pointer.touch && !none) return;
  if (none && pointer.touch && state.view.hover.kind == Pick::Kind::object) return;
  Pick under;
  if (!none && state.view.tool == Tool::transform) {
    if (const auto grip = grip_at(state, pointer.at)) {
      under.kind = Pick::Kind::frame;
      under.index = static_cast<std::size_t>(*grip);
    }
  } else if (!none) {
    under = pick(state, pointer.at, pointer.second);
  }
  hover_over(state, pointer, under, commands);
  if (walkthrough_is_open(state)) {
    const auto figure = none ? std::nullopt : figure_at(state, pointer.at);
    if (figure != state.view.walkthrough.hovered) commands.push_back(HoverFigure{figure});
  }
}

}  // namespace

void interact(const AppState& state, const Pointer& pointer, Commands& commands) {
  if (pointer.pinching) return pinch(state, pointer, commands);
  const bool holding = state.view.held.kind != Pick::Kind::none;
  if (holding && pointer.down)
    drag(state, pointer, commands);
  else if (holding)
    release(state, pointer, commands);
  else if (pointer.pressed && !pointer.over_panel)
    press(state, pointer, commands);
  if (!holding) hover(state, pointer, commands);
  if (pointer.wheel != 0 && pointer.present && !pointer.over_panel) {
    const double factor = std::exp(pointer.wheel * 0.18);
    commands.push_back(ZoomView{factor, pointer.at});
  }
}

}  // namespace evenlift::view
