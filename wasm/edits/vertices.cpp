#include "edits/vertices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "edits/undo.h"
#include "evenlift/document.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/polygon_with_holes.h"
#include "evenlift/settings.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/layout.h"
#include "state/screen.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

void put_in_hole(AppState& state, const Handle& edge, const Vec2& at) {
  Points& ring = ring_of(edit(state, false, Edit::vertex_added), edge.ring);
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(edge.index) + 1, at);
}

void remove_from_hole(AppState& state, const Handle& vertex) {
  const bool last = ring_of(state.work.document(), vertex.ring).size() <= 3;
  Document& document = edit(state, false, last ? Edit::hole_removed : Edit::vertex_removed);
  Points& ring = ring_of(document, vertex.ring);
  if (last)
    document.holes.erase(document.holes.begin() + static_cast<std::ptrdiff_t>(vertex.ring) - 1);
  else
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(vertex.index));
}

void remove_from_outline(AppState& state, std::size_t vertex) {
  Document& document = edit(state, false, Edit::vertex_removed);
  Points& vertices = document.vertices;
  document.settings.no_go =
      after_removal(document.settings.no_go, vertices, static_cast<std::uint32_t>(vertex));
  if (state.work.aside.no_go)
    state.work.aside.no_go =
        after_removal(*state.work.aside.no_go, vertices, static_cast<std::uint32_t>(vertex));
  vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(vertex));
}

void remove_weight(AppState& state, std::size_t item) {
  std::vector<Cargo>& cargo = edit(state, false, Edit::weight_removed).settings.cargo;
  cargo.erase(cargo.begin() + static_cast<std::ptrdiff_t>(item));
}

// A tenth of the object's own weight, with one digit.
double usual_weight(const Settings& settings) {
  const double tenth = settings.weight / 10, unit = std::pow(10, std::floor(std::log10(tenth)));
  return std::clamp(std::round(tenth / unit) * unit, min_weight, max_weight);
}

}  // namespace

void move_handle(AppState& state, std::size_t number, const Vec2& to) {
  const std::optional<Handle> handle = handle_of(state.work.document(), number);
  if (!handle || place_of(state.work.document(), number) == to) return;
  if (!state.work.edit_open) state.view.grip = grip_of(state.work.document());
  Document& document =
      edit(state, true, handle->is_weight ? Edit::weight_moved : Edit::vertex_moved);
  put(document, number, to);
  if (!handle->is_weight) carry_supports(document, state.view.grip);
}

void insert_vertex(AppState& state, std::size_t edge, const Vec2& at) {
  const std::optional<Handle> handle = handle_of(state.work.document(), edge);
  if (!handle || handle->is_weight) return;
  state.view.selected = edge + 1;
  if (handle->ring > 0) return put_in_hole(state, *handle, at);
  Document& document = edit(state, false, Edit::vertex_added);
  Points& vertices = document.vertices;
  const Vec2 &a = vertices[edge], &b = vertices[(edge + 1) % vertices.size()];
  const double part = std::clamp(dot(at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
  document.settings.no_go =
      after_split(document.settings.no_go, static_cast<std::uint32_t>(edge), part);
  if (state.work.aside.no_go)
    state.work.aside.no_go =
        after_split(*state.work.aside.no_go, static_cast<std::uint32_t>(edge), part);
  vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(edge) + 1, at);
}

void remove_handle(AppState& state, std::size_t number) {
  const std::optional<Handle> handle = handle_of(state.work.document(), number);
  if (!handle) return;
  if (!handle->is_weight && handle->ring == 0 && state.work.document().vertices.size() <= 3) {
    show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
    return;
  }
  const std::string name = name_of(state.work.document(), number);
  const std::size_t holes = state.work.document().holes.size();
  if (handle->is_weight)
    remove_weight(state, handle->index);
  else if (handle->ring > 0)
    remove_from_hole(state, *handle);
  else
    remove_from_outline(state, handle->index);
  state.view.selected.reset();
  state.view.hover = state.view.held = {};
  const bool whole_hole = state.work.document().holes.size() < holes;
  announce(state, whole_hole ? say("Hole {hole} removed.", {handle->ring})
                             : say("{part} removed.", {name}));
}

void add_weight(AppState& state, const Vec2& at) {
  if (state.work.document().settings.cargo.size() == max_cargo)
    return show(state, {Notice::Kind::problem, "There can be at most 1000 weights."});
  Document& document = edit(state, false, Edit::weight_added);
  document.settings.cargo.push_back({at, usual_weight(document.settings), {}});
  state.view.selected = count_handles(document) - 1;
  announce(state, say("{part} added.", {name_of(document, *state.view.selected)}));
}

std::string problem_of(const Cargo& item) {
  const auto is_refused = [](const Cargo& cargo) {
    Settings settings;
    settings.cargo = {cargo};
    return check_ranges(settings).has_value();
  };
  if (!is_refused(item)) return {};
  return say(is_refused({item.at, item.weight, {}})
                 ? "A weight must be a number greater than 0, at most 1e100, at a place within 1e9"
                 : "The name of a weight must be text of at most 60 characters");
}

void set_weight(AppState& state, std::size_t item, const Cargo& cargo) {
  if (const std::string problem = problem_of(cargo); !problem.empty())
    return show(state, {Notice::Kind::problem, problem + "."});
  const std::vector<Cargo>& now = state.work.document().settings.cargo;
  if (item >= now.size() || now[item] == cargo) return;
  edit(state, false, Edit::weight_changed).settings.cargo[item] = cargo;
}

void grip_polygon(AppState& state) { state.view.grip = grip_of(state.work.document()); }

namespace {

bool move_last(Points& from, Points& to) {
  if (from.empty()) return false;
  to.push_back(from.back());
  from.pop_back();
  return true;
}

// Why the drawn hole does not fit the object with those of its holes that do; nothing if it fits.
std::optional<InputError> problem_of_hole(const AppState& state, const Points& hole) {
  Document with = state.work.document();
  if (state.derived().placement && !state.derived().refusal)
    with.holes = state.derived().placement->object.rings_of_holes();
  with.holes.push_back(hole);
  const Result<PolygonWithHoles> object = object_of(with);
  if (object) return std::nullopt;
  return object.error();
}

// Finds out why the drawn shape or hole cannot be closed.
void check_drawing(AppState& state) {
  Drawing& drawing = state.view.drawing;
  if (drawing.checked) return;
  drawing.checked = true;
  if (state.view.tool == Tool::hole) {
    drawing.refusal = problem_of_hole(state, drawing.points);
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

namespace {

// Returns whether a drawing is left that is worth going on with.
bool leave_drawing(AppState& state) {
  const Points& points = state.view.drawing.points;
  if (!draws(state.view.tool) || points.size() < 2) return false;
  state.view.left_drawing = {state.view.tool, points, state.work.edits(),
                             state.work.history.depth()};
  return true;
}

}  // namespace

void go_on_drawing(AppState& state) {
  const LeftDrawing left = *std::exchange(state.view.left_drawing, std::nullopt);
  take_tool(state, left.tool);
  state.view.drawing.points = left.points;
  state.view.drawing.last_cursor = left.points.back();
  renew_drawing(state);
  announce(state, "The unfinished drawing is back.");
}

void take_tool(AppState& state, Tool tool) {
  if (draws(tool) && walkthrough_is_open(state)) close_walkthrough(state);
  const bool left = leave_drawing(state);
  state.view.tool = tool;
  emit(state, SummaryChanged{});
  state.view.card.ask(std::nullopt);
  if (!state.view.drawing.points.empty()) emit(state, DocumentChanged{});
  state.view.drawing = {};
  state.view.selected.reset();
  state.view.hover = state.view.held = {};
  if (draws(tool)) state.work.second_method.reset();
  show(state, {});
  if (left)
    show(state,
         {Notice::Kind::info, say("The unfinished drawing is put aside."), say("Go on drawing")});
  if (tool == Tool::robot)
    announce(state, "Click the outline or the object to add a robot there; Esc ends it.");
  if (tool == Tool::hole)
    announce(state, "Draw a hole in the object, vertex by vertex; Esc ends it.");
  if (tool == Tool::weight) announce(state, "Click the object to put cargo there; Esc ends it.");
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
  if (const auto problem = problem_of_hole(state, state.view.drawing.points))
    return refuse_drawing(state, *problem);
  const Points hole = state.view.drawing.points;
  std::vector<Points>& holes = edit(state, false, Edit::hole_drawn).holes;
  holes.push_back(hole);
  state.view.drawing = {};
  take_tool(state, Tool::parts);
  announce(state, say("Hole {hole} drawn.", {state.work.document().holes.size()}));
}

}  // namespace

void finish_drawing(AppState& state) {
  if (state.view.tool == Tool::hole) return finish_hole(state);
  Result<Opened> polygon = opened_after({state.view.drawing.points, {}}, state.work);
  if (!polygon) return refuse_drawing(state, polygon.error());
  open(state, std::move(polygon).value(), Edit::drawn);
  if (state.work.backdrop) state.work.backdrop->traced = true;
}

namespace {

void show_all_of_it(AppState& state) {
  state.view.camera = fitting_camera(state);
  state.view.camera_follows = true;  // cards come and go beside it
}

struct Scaled {
  Vec2 low;
  double factor;
  Vec2 operator()(const Vec2& p) const { return (p - low) * factor; }
  void operator()(Points& points) const {
    for (Vec2& p : points) p = (*this)(p);
  }
  void operator()(std::optional<Vec2>& p) const {
    if (p) p = (*this)(*p);
  }
};

bool all_within(const Points& points, const Scaled& scaled) {
  return std::all_of(points.begin(), points.end(),
                     [&](const Vec2& p) { return max_norm(scaled(p)) <= max_coordinate; });
}

void scale_drawing(AppState& state, const Scaled& scaled) {
  Drawing& drawing = state.view.drawing;
  for (Points* points : {&drawing.points, &drawing.undone}) scaled(*points);
  for (std::optional<Vec2>* cursor : {&drawing.cursor, &drawing.last_cursor}) scaled(*cursor);
  renew_drawing(state);
}

}  // namespace

void lay_behind(AppState& state, const Vec2& low, const Vec2& high) {
  state.work.backdrop = Backdrop{low, high, ++state.work.pictures};
  if (!draws(state.view.tool)) take_tool(state, Tool::draw);
  show_all_of_it(state);
}

void take_picture_away(AppState& state) { state.work.backdrop.reset(); }

std::string scale_picture(AppState& state, double width) {
  if (!state.work.backdrop) return {};
  const Scaled scaled{state.work.backdrop->low, width / state.work.backdrop->width()};
  const bool drawing = draws(state.view.tool), traced = !drawing && state.work.backdrop->traced;
  Points corners = drawing  ? state.view.drawing.points
                   : traced ? state.work.document().vertices
                            : Points();
  corners.push_back(state.work.backdrop->high);
  if (!(scaled.factor > 0) || !std::isfinite(scaled.factor)) return say("It would have no size");
  if (!all_within(corners, scaled))
    return say("The picture would reach beyond the largest coordinate");
  Document* document = traced ? &edit(state, false, Edit::whole) : nullptr;
  state.work.backdrop->high = scaled(state.work.backdrop->high);
  state.work.backdrop->low = Vec2(0, 0);
  if (drawing) scale_drawing(state, scaled);
  if (document) {
    scaled(document->vertices);
    for (Points& hole : document->holes) scaled(hole);
    for (Cargo& item : document->settings.cargo) item.at = scaled(item.at);
    scaled(document->centre_of_mass);
  }
  show_all_of_it(state);
  return {};
}

}  // namespace evenlift::view
