#include "edits/draw_polygon.h"

#include <cmath>
#include <string>
#include <utility>

#include "edits/editing.h"
#include "edits/open_document.h"
#include "edits/sight.h"
#include "evenlift/output/words.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/wording.h"
#include "state/layout.h"
#include "state/notice.h"
#include "state/opened.h"
#include "tools/drawing.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

bool move_last(Points& from, Points& to) {
  if (from.empty()) return false;
  to.push_back(from.back());
  from.pop_back();
  return true;
}

// The document with the drawn hole last, or why it cannot have it.
Result<Document> with_hole(const Document& document, const Points& hole) {
  Document with = document;
  with.holes.push_back(hole);
  const Result<PolygonWithHoles> object = object_of(with);
  if (!object) return object.error();
  return with;
}

// Finds out why the drawn shape or hole cannot be closed.
void check_drawing(AppState& state) {
  Drawing& drawing = state.view.drawing;
  if (drawing.checked) return;
  drawing.checked = true;
  if (state.view.tool == Tool::hole) {
    const Result<Document> with = with_hole(state.work.document(), drawing.points);
    if (!with) drawing.refusal = with.error();
  } else {
    const Result<Polygon> polygon = Polygon::create(drawing.points);
    if (!polygon) drawing.refusal = polygon.error();
  }
}

}  // namespace

void renew_drawing(AppState& state) {
  Drawing& drawing = state.view.drawing;
  drawing.length.reset();
  drawing.degrees.reset();
  drawing.checked = false;
  drawing.refusal.reset();
  show(state, {});
  emit(state, DocumentChanged{});
}

void take_tool(AppState& state, Tool tool) {
  if (draws(tool) && walkthrough_is_open(state)) close_walkthrough(state);
  state.view.tool = tool;
  emit(state, SummaryChanged{});
  state.view.card.ask(std::nullopt);
  if (!state.view.drawing.points.empty()) emit(state, DocumentChanged{});
  state.view.drawing = {};
  state.view.selected.reset();
  state.view.hover = state.view.held = {};
  if (draws(tool)) state.work.second_method.reset();
  show(state, {});
  if (tool == Tool::robot)
    announce(state, "Click the outline or the object to add a robot there; Esc ends it.");
  if (tool == Tool::hole)
    announce(state, "Draw a hole in the object, vertex by vertex; Esc ends it.");
  if (tool == Tool::weight) announce(state, "Click the object to put a weight there; Esc ends it.");
  if (tool == Tool::mark)
    announce(
        state,
        "Drag along the boundary to mark no-go parts, or type the numbers of edges in the field No-go edges.");
}

void add_point(AppState& state, const Vec2& at) {
  Points& points = state.view.drawing.points;
  if (!points.empty() && points.back() == at) return;
  points.push_back(at);
  // The next edge begins here, even without a cursor: a finger has none between two taps.
  state.view.drawing.last_cursor = at;
  if (state.view.drawing.cursor) state.view.drawing.cursor = at;
  state.view.drawing.undone.clear();
  renew_drawing(state);
}

void move_point(AppState& state, std::size_t point, const Vec2& to) {
  Points& points = state.view.drawing.points;
  if (point >= points.size() || points[point] == to) return;
  points[point] = to;
  renew_drawing(state);
}

void take_point_back(AppState& state) {
  if (move_last(state.view.drawing.points, state.view.drawing.undone)) renew_drawing(state);
}

void put_point_back(AppState& state) {
  if (move_last(state.view.drawing.undone, state.view.drawing.points)) renew_drawing(state);
}

void set_draw_cursor(AppState& state, const SetDrawCursor& cursor) {
  Drawing& drawing = state.view.drawing;
  drawing.cursor = cursor.at;
  if (cursor.at) drawing.last_cursor = cursor.at;
  if (cursor.by_keys)
    keep_in_sight(state, *cursor.at);
  else
    drawing.pointer = cursor.pointer;
  if (cursor.by_keys || drawing.by_keys) emit(state, SummaryChanged{});
  drawing.by_keys = cursor.by_keys;
  if (cursor.at && closes(state, state.view.camera.to_screen(*cursor.at))) check_drawing(state);
}

void type_edge(AppState& state, const TypeEdge& typed) {
  Drawing& drawing = state.view.drawing;
  if (drawing.points.empty()) return;
  if (typed.length && !(*typed.length > 0 && *typed.length <= max_coordinate))
    return show(state, {Notice::Kind::problem, "The length of an edge must be a number above 0."});
  if (typed.degrees && !(std::abs(*typed.degrees) <= 360))
    return show(state,
                {Notice::Kind::problem, "The angle of an edge must be between −360° and 360°."});
  if (typed.length) drawing.length = typed.length;
  if (typed.degrees) drawing.degrees = typed.degrees;
  const Vec2 from = drawing.points.back(),
             towards = drawing.cursor.value_or(drawing.last_cursor.value_or(from));
  if (!drawing.length && towards == from) {
    if (typed.place) show(state, {Notice::Kind::problem, "Also type the length of the edge."});
    return;
  }
  const Vec2 to = typed_end(drawing, towards);
  if (!(std::abs(to.x) <= max_coordinate && std::abs(to.y) <= max_coordinate))
    return show(state,
                {Notice::Kind::problem, "The edge would end beyond the largest coordinate."});
  drawing.cursor = drawing.last_cursor = to;
  drawing.by_keys = true;
  keep_in_sight(state, to);
  if (typed.place) add_point(state, to);
  emit(state, SummaryChanged{});
}

void withdraw_edge(AppState& state) {
  Drawing& drawing = state.view.drawing;
  if (drawing.points.empty() || (!drawing.length && !drawing.degrees)) return;
  drawing.length.reset();
  drawing.degrees.reset();
  const Vec2 to = drawing.pointer ? next_point(state, state.view.camera.to_world(*drawing.pointer))
                                  : drawing.points.back();
  drawing.last_cursor = to;
  if (drawing.cursor) drawing.cursor = to;
  drawing.by_keys = false;
  emit(state, SummaryChanged{});
}

namespace {

void refuse_drawing(AppState& state, const InputError& error) {
  state.view.drawing.checked = true;
  state.view.drawing.refusal = error;
  show(state, {Notice::Kind::problem, sentence(error) + "."});
}

void finish_hole(AppState& state) {
  const Result<Document> with = with_hole(state.work.document(), state.view.drawing.points);
  if (!with) return refuse_drawing(state, with.error());
  edit(state, false, Edit::hole_drawn).holes = with->holes;
  take_tool(state, Tool::parts);
  announce(state, say("Hole {hole} drawn.", {with->holes.size()}));
}

}  // namespace

void finish_drawing(AppState& state) {
  if (state.view.tool == Tool::hole) return finish_hole(state);
  Result<Opened> polygon = opened_after({state.view.drawing.points, {}}, state.work.document());
  if (!polygon) return refuse_drawing(state, polygon.error());
  open(state, std::move(polygon).value(), Edit::drawn);
  if (state.work.backdrop) state.work.backdrop->traced = true;
}

}  // namespace evenlift::view
