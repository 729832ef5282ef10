#include "app/update.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/by_hand.h"
#include "app/outlook.h"
#include "app/search.h"
#include "evenlift/document.h"
#include "evenlift/link.h"
#include "evenlift/moved.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/polygon.h"
#include "state/browser.h"
#include "state/layout.h"
#include "state/method.h"
#include "state/opened.h"
#include "tools/drawing.h"
#include "walkthrough/explain.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Times the view that fits. Larger ones would make screen coordinates unfit for floats.
constexpr double largest_zoom = 1000, smallest_zoom = 0.25;

void show(AppState& state, Notice notice) {
  if (notice.text != state.notice.text) browser::announce(notice.text);
  state.notice = std::move(notice);
}

// Two pictures of one method would show no difference: if the document takes over the second
// method, the two methods are exchanged.
void part_methods(AppState& state, Method former) {
  const Method now = state.document.settings.method;
  if (state.second_method != now) return;
  state.second_method = former == now ? std::nullopt : std::optional<Method>(former);
}

// Takes over the placement of the document, or why it is refused.
void adopt(AppState& state, Result<Placement> placement) {
  ++state.revision;
  drop_search(state);
  state.explanation.reset();
  forget_failures(state);
  part_methods(state, state.placed.settings.method);
  const std::string before = state.refusal ? sentence(*state.refusal) : std::string();
  if (placement) {
    state.plan_due |= !state.placement || !same_plan(*state.placement, *placement) ||
                      state.placement->settings.capacity != placement->settings.capacity;
    // The view makes room for larger robots.
    state.fit_due |=
        state.camera_follows && !(state.placed.settings.robot == settings(state).robot);
    state.placement = std::move(placement).value();
    state.placed = state.document;
    state.refusal.reset();
  } else {
    state.refusal = placement.error();
  }
  show(state, {});
  const std::string now = state.refusal ? sentence(*state.refusal) : std::string();
  if (now != before) browser::announce(now);
  browser::document_changed();
}

// The candidates if any load ratio were good enough.
Result<std::vector<Candidate>> all_candidates(const Placement& placement) {
  const Polygon& polygon = placement.polygon;
  if (!placement.stands) return find_candidates(polygon, placement.centre_of_mass, 0);
  auto found = standing_candidates(polygon, placement.centre_of_mass, 0, *placement.stands);
  if (!found) return found.error();
  return std::move(found->candidates);
}

// If no chord is even enough, the best load ratio that there is.
std::optional<double> best_ratio_if_none(const Placement& placement) {
  if (!placement.teams.empty() || !selects_candidates(placement.settings.method))
    return std::nullopt;
  const auto any = all_candidates(placement);
  if (!any || any->empty()) return std::nullopt;
  double best = 0;
  for (const Candidate& c : *any) best = std::max(best, c.chord.ratio);
  // Two decimals, as the slider has, and none of them too many.
  return std::floor(best * 100) / 100;
}

Haste haste(const AppState& state) { return state.edit_open ? Haste::drag : Haste::at_rest; }

// Places the second method, if there is one.
void renew_second(AppState& state) {
  constexpr auto balanced = Method::balanced;
  if (state.second && state.second->settings.method == balanced) drop_search(state);
  state.second.reset();
  if (!state.second_method) return;
  if (state.second_method == balanced) drop_search(state);
  Document document = state.placed;
  document.moved = {};
  const std::uint32_t teams = placed_teams(state);
  // So that both methods have as many teams.
  if (!document.settings.teams && document.settings.method != balanced)
    document.settings.teams = teams;
  document.settings = with_method(document.settings, *state.second_method, teams);
  if (Result<Placement> placement = compute_placement(document, state.placement, haste(state)))
    state.second = std::move(placement).value();
}

// The plan for the capacity, if it can have changed; not during a drag, in which nobody reads it.
void renew_plan(AppState& state) {
  if (state.refusal || state.edit_open || !state.plan_due) return;
  state.plan.reset();
  const std::optional<double>& capacity = settings(state).capacity;
  if (capacity) state.plan = plan_capacity(*state.placement, *capacity);
  state.plan_due = false;
}

// Says at rest that teams are not exchanged, since nobody would wait for it.
void tell_of_no_exchange(AppState& state) {
  if (!waits_for_exchange(*state.placement)) return;
  show(state,
       {Notice::Kind::info, "So many teams are not exchanged here until they hold: among " +
                                std::to_string(state.placement->candidates.size()) +
                                " candidates that would take too long. The program does it."});
}

// Computes what is shown beside the placement. The best ratio, the plan and the search for balanced
// robots wait for the end of a drag.
void follow_up(AppState& state) {
  if (state.refusal) return;
  renew_second(state);
  renew_outlook(state);
  state.best_ratio.reset();
  if (!state.edit_open) {
    tell_of_no_exchange(state);
    state.best_ratio = best_ratio_if_none(*state.placement);
    renew_plan(state);
    begin_search(state);
  }
  renew_failures(state);
}

// Places the document anew. Robots that were moved by hand go back, unless they are to stay.
void recompute(AppState& state, bool robots_stay = false) {
  if (!robots_stay) state.document.moved = {};
  adopt(state, compute_placement(state.document, state.placement, haste(state)));
  follow_up(state);
  follow_placement(state);
}

// During a drag the walkthrough shows only the start of a search for balanced robots.
void trace_whole_search(AppState& state) {
  const std::optional<Trace>& trace = state.walkthrough.trace;
  if (trace && trace->balanced() && !trace->placement.search_ended) follow_placement(state);
}

// Forgets a selection of, or a grip on, a vertex that no longer exists.
void drop_stale_picks(AppState& state) {
  const std::size_t count = state.document.vertices.size();
  if (state.selected && *state.selected >= count) state.selected.reset();
  for (Pick* pick : {&state.hover, &state.held}) {
    const bool of_polygon = pick->kind == Pick::Kind::vertex || pick->kind == Pick::Kind::edge;
    if (of_polygon && pick->index >= count) *pick = {};
  }
}

Beside beside(const AppState& state) { return {state.second_method}; }

void begin_edit(AppState& state, bool live, Edit edit) {
  if (live && state.edit_open) return;
  state.history.record(state.document, beside(state), edit);
  state.edit_open = live;
}

// Whether balanced robots are to hold as firmly.
bool same_margin(const Settings& a, const Settings& b) {
  return a.min_margin == b.min_margin && a.apart == b.apart && a.survive == b.survive;
}

// The settings with what places nothing taken over from others.
Settings placing_as(Settings settings, const Settings& other) {
  settings.step = other.step;
  settings.capacity = other.capacity;
  settings.com_radius = other.com_radius;
  settings.units = other.units;
  return settings;
}

// Whether robots stand at the same places with both.
bool stand_alike(const Settings& a, const Settings& b) {
  Settings but = placing_as(a, b);
  but.weight = b.weight;
  but.overlays = b.overlays;
  return but == b;
}

// The setting that differs, if it is only one.
Edit edit_between(const Settings& before, const Settings& after) {
  Edit edit = Edit::settings;
  int differing = 0;
  const auto compare = [&](bool same, Edit which) {
    if (same) return;
    edit = which;
    ++differing;
  };
  compare(before.teams == after.teams, Edit::teams);
  compare(before.method == after.method, Edit::method);
  compare(before.min_ratio == after.min_ratio, Edit::min_ratio);
  compare(before.weight == after.weight, Edit::weight);
  compare(before.seed == after.seed, Edit::seed);
  compare(before.robots == after.robots, Edit::robots);
  compare(before.goal == after.goal && same_margin(before, after), Edit::goal);
  compare(before.positions == after.positions, Edit::positions);
  compare(before.capacity == after.capacity, Edit::capacity);
  compare(before.com_radius == after.com_radius, Edit::com_radius);
  compare(before.robot == after.robot, Edit::robot_size);
  compare(before.no_go == after.no_go, Edit::marks);
  return differing == 1 ? edit : Edit::settings;
}

void fit_view(AppState& state) { state.camera_follows = state.fit_due = true; }

// Forgets what belonged to the former document.
void forget_former(AppState& state) {
  if (state.tool == Tool::draw) state.tool = Tool::parts;
  state.drawing = {};
  state.selected.reset();
  state.hover = state.held = {};
  // The walkthrough begins with the document's step, if it has one.
  state.walkthrough.trace.reset();
  state.walkthrough.script.reset();
  state.walkthrough.playing = false;
  state.walkthrough.visited.clear();
  state.walkthrough.guesses = {};
  state.walkthrough.at = 0;
  state.walkthrough.all_steps = false;
  fit_view(state);
}

// Shows a document in place of the former one. The caller records the step of undo.
void show_opened(AppState& state, Opened opened) {
  forget_former(state);
  state.document = std::move(opened.document);
  adopt(state, std::move(opened.placement));
  follow_up(state);
  follow_placement(state, std::move(opened.trace));
}

void open(AppState& state, Opened opened, Edit edit = Edit::opened) {
  begin_edit(state, false, edit);
  show_opened(state, std::move(opened));
}

// After a change of the placed vertices.
void renew_drawing(AppState& state) {
  Drawing& drawing = state.drawing;
  drawing.length.reset();
  drawing.degrees.reset();
  drawing.checked = false;
  drawing.refusal.reset();
  show(state, {});
  browser::document_changed();
}

void check_drawing(Drawing& drawing) {
  if (drawing.checked) return;
  drawing.checked = true;
  const Result<Polygon> polygon = Polygon::create(drawing.points);
  if (!polygon) drawing.refusal = polygon.error();
}

void add_point(AppState& state, const Vec2& at) {
  Points& points = state.drawing.points;
  if (!points.empty() && points.back() == at) return;
  points.push_back(at);
  state.drawing.undone.clear();
  renew_drawing(state);
}

// A cursor that keys move stays in sight: the drawing moves along.
void keep_in_sight(AppState& state, const Vec2& at) {
  const Rect& free = layout(state).free;
  const Vec2 spot = state.camera.to_screen(at);
  constexpr double edge = 48;
  const Vec2 wanted(
      std::clamp(spot.x(), free.left + edge, std::max(free.left + edge, free.right - edge)),
      std::clamp(spot.y(), free.top + edge, std::max(free.top + edge, free.bottom - edge)));
  if (wanted == spot) return;
  state.camera = pan(state.camera, wanted - spot);
  state.camera_follows = false;
}

// Takes over what was typed of the next edge, and moves the cursor there.
void type_edge(AppState& state, const TypeEdge& typed) {
  Drawing& drawing = state.drawing;
  if (drawing.points.empty()) return;
  if (typed.length && !(*typed.length > 0 && *typed.length <= max_coordinate))
    return show(state, {Notice::Kind::problem, "The length of an edge is a number above 0."});
  if (typed.degrees && !(std::abs(*typed.degrees) <= 360))
    return show(state, {Notice::Kind::problem, "The angle of an edge is between −360° and 360°."});
  if (typed.length) drawing.length = typed.length;
  if (typed.degrees) drawing.degrees = typed.degrees;
  const Vec2 from = drawing.points.back(),
             towards = drawing.cursor.value_or(drawing.last_cursor.value_or(from));
  if (!drawing.length && towards == from)
    return show(state, {Notice::Kind::problem, "Type the length of the edge, too."});
  const Vec2 to = typed_end(drawing, towards);
  if (!(std::abs(to.x()) <= max_coordinate && std::abs(to.y()) <= max_coordinate))
    return show(state,
                {Notice::Kind::problem, "The edge would end beyond the largest coordinate."});
  drawing.cursor = drawing.last_cursor = to;
  drawing.by_keys = true;
  keep_in_sight(state, to);
  if (typed.place) add_point(state, to);
  browser::summary_changed();
}

// Opens the polygon that was drawn, with the present settings.
void finish_drawing(AppState& state) {
  Document drawn;
  drawn.vertices = state.drawing.points;
  drawn.settings = state.document.settings;
  drawn.settings.step.reset();
  drawn.settings.com_radius = 0;  // a length of the former polygon
  drawn.settings.no_go.clear();   // and its edges
  Result<Opened> polygon = opened(std::move(drawn));
  if (!polygon) {
    state.drawing.checked = true;
    state.drawing.refusal = polygon.error();
    show(state, {Notice::Kind::problem, sentence(polygon.error()) + "."});
    return;
  }
  open(state, std::move(polygon).value(), Edit::drawn);
}

// A centre of mass that was dragged under a panel is brought back into view.
bool centre_is_shown(const AppState& state) {
  return !state.document.centre_of_mass ||
         layout(state).free.contains(state.camera.to_screen(*state.document.centre_of_mass));
}

// Whether the camera shows all vertices, and not much smaller than they could be.
bool well_shown(const AppState& state) {
  const Screen& screen = state.screen;
  const double best = fitting_camera(state).scale;
  if (state.camera.scale < best * 0.4) return false;
  const Rect window{0, 0, screen.width, screen.height};
  return std::all_of(state.document.vertices.begin(), state.document.vertices.end(),
                     [&](const Vec2& p) { return window.contains(state.camera.to_screen(p)); });
}

// Changes settings that place nothing, in the document and its placement. The plan and what is shown of the
// loads follow.
template <class Change>
void change_beside(AppState& state, bool live, Edit edit, const Change& change) {
  begin_edit(state, live, edit);
  const std::optional<double> capacity = settings(state).capacity;
  change(state.document.settings);
  change(state.placed.settings);
  for (std::optional<Placement>* placement : {&state.placement, &state.second})
    if (*placement) change((*placement)->settings);
  if (state.walkthrough.trace) change(state.walkthrough.trace->placement.settings);
  state.plan_due |= settings(state).capacity != capacity;
  renew_plan(state);
  renew_outlook(state);
  browser::document_changed();
}

// One step of undo, unless no robot was moved.
void put_robots_back(AppState& state) {
  if (!state.document.moved.any()) return;
  begin_edit(state, false, Edit::robots_reset);
  recompute(state);
}

// The steps of a lesson are those of teams where they were found.
void put_teams_back(AppState& state) {
  if (!state.document.moved.teams.empty()) put_robots_back(state);
}

// Undo and redo. Those who cannot see what changed are told.
void step_back(AppState& state, History::Recalled recalled, const char* what) {
  Document& document = recalled.document;
  const bool other_shape = document.vertices.size() != state.document.vertices.size();
  state.edit_open = false;
  // The step of the walkthrough is not undone, except when undo leaves a script: then the former
  // step comes back.
  if (state.walkthrough.script && state.history.depth() < state.walkthrough.script->depth)
    state.walkthrough.script.reset();
  else
    document.settings.step = state.document.settings.step;
  document.settings.overlays = state.document.settings.overlays;  // neither are the overlays
  // A lesson would show teams elsewhere.
  if (!document.moved.teams.empty()) document.settings.step.reset();
  state.document = std::move(document);
  if (other_shape) state.selected.reset();
  drop_stale_picks(state);
  if (state.camera_follows && !well_shown(state)) state.fit_due = true;
  state.second_method.reset();  // so that the two methods are not exchanged
  adopt(state, compute_placement(state.document, state.placement));
  if (!walkthrough_is_open(state)) state.second_method = recalled.beside.second_method;
  follow_up(state);
  follow_placement(state);
  if (!state.refusal) browser::announce(what + std::string(in_words(recalled.edit)) + ".");
}

// Leaving a lesson brings the settings back that it found, unless they were changed since.
void leave_lesson(AppState& state) {
  const std::optional<Settings> before = settings_before_script(state);
  close_walkthrough(state);
  if (!before || same_settings(*before, settings(state))) return;
  begin_edit(state, false, Edit::lesson_left);
  const Overlays overlays = settings(state).overlays;
  state.document.settings = *before;
  state.document.settings.overlays = overlays;
  state.document.settings.step.reset();
  recompute(state);
}

void zoom_view(AppState& state, const Vec2& about, double factor) {
  const double fitting = fitting_camera(state).scale;
  state.camera = zoom(state.camera, about, factor, fitting * smallest_zoom, fitting * largest_zoom);
  state.camera_follows = false;
}

struct Applier {
  AppState& state;

  void operator()(const SetSettings& c) const {
    if (c.settings == state.document.settings) return;
    begin_edit(state, c.live, edit_between(settings(state), c.settings));
    const bool robots_stay = stand_alike(c.settings, settings(state));
    state.document.settings = c.settings;
    recompute(state, robots_stay);
  }
  void operator()(const MoveVertex& c) const {
    if (c.vertex >= state.document.vertices.size() || state.document.vertices[c.vertex] == c.to)
      return;
    begin_edit(state, true, Edit::vertex_moved);
    state.document.vertices[c.vertex] = c.to;
    recompute(state);
  }
  void operator()(const MoveCentre& c) const {
    if (state.document.centre_of_mass == c.to) return;
    begin_edit(state, true, Edit::centre_moved);
    state.document.centre_of_mass = c.to;
    recompute(state);
  }
  void operator()(const ReleaseCentre&) const {
    if (!state.document.centre_of_mass) return;
    begin_edit(state, false, Edit::centre_released);
    state.document.centre_of_mass.reset();
    recompute(state);
  }
  void operator()(const InsertVertex& c) const {
    Points& vertices = state.document.vertices;
    if (c.edge >= vertices.size()) return;
    begin_edit(state, false, Edit::vertex_added);
    const Vec2 &a = vertices[c.edge], &b = vertices[(c.edge + 1) % vertices.size()];
    const double part = std::clamp(dot(c.at - a, b - a) / dot(b - a, b - a), 0.0, 1.0);
    state.document.settings.no_go =
        after_split(settings(state).no_go, static_cast<std::uint32_t>(c.edge), part);
    vertices.insert(vertices.begin() + static_cast<std::ptrdiff_t>(c.edge) + 1, c.at);
    state.selected = c.edge + 1;
    recompute(state);
  }
  void operator()(const RemoveVertex& c) const {
    Points& vertices = state.document.vertices;
    if (c.vertex >= vertices.size()) return;
    if (vertices.size() <= 3) {
      show(state, {Notice::Kind::problem, "A polygon needs at least 3 vertices."});
      return;
    }
    begin_edit(state, false, Edit::vertex_removed);
    state.document.settings.no_go =
        after_removal(settings(state).no_go, vertices, static_cast<std::uint32_t>(c.vertex));
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(c.vertex));
    state.selected.reset();
    state.hover = state.held = {};
    recompute(state);
  }
  void operator()(OpenDocument& c) const { open(state, std::move(c.opened)); }
  void operator()(const SetPolygon& c) const {
    if (c.vertices == state.document.vertices) return;
    begin_edit(state, c.live, Edit::whole);
    state.document.vertices = c.vertices;
    state.document.centre_of_mass = c.centre_of_mass;
    recompute(state);
  }
  void operator()(const EndEdit&) const {
    if (!state.edit_open) return;
    state.edit_open = false;
    if (state.camera_follows && !centre_is_shown(state)) state.fit_due = true;
    const std::optional<Placement>& placement = state.placement;
    if (!state.refusal && placement && waits_for_exchange(*placement)) return recompute(state);
    trace_whole_search(state);
    follow_up(state);
  }
  void operator()(const MoveRobot& c) const {
    const std::optional<Moved> moved = moved_by_hand(state, c.robot, c.to);
    if (!moved || *moved == state.document.moved) return;
    Result<Placement> placement = with_moved(*state.placement, *moved);
    if (!placement) return refuse_by_hand(state, c.to);  // two robots would meet
    begin_edit(state, true, Edit::robots_moved);
    show_moved(state, c.robot, std::move(placement).value());
  }
  void operator()(const ResetRobots&) const { put_robots_back(state); }
  void operator()(const Undo&) const {
    if (state.history.can_undo())
      step_back(state, state.history.undo(state.document, beside(state)), "Undone: ");
  }
  void operator()(const Redo&) const {
    if (state.history.can_redo())
      step_back(state, state.history.redo(state.document, beside(state)), "Done again: ");
  }

  // Overlays are no edit: they compute nothing and cannot be undone. Links carry them.
  void operator()(const Show& c) const {
    if (c.overlays == state.document.settings.overlays) return;
    state.document.settings.overlays = state.placed.settings.overlays = c.overlays;
    if (state.placement) state.placement->settings.overlays = c.overlays;
    browser::document_changed();
  }
  void operator()(const SetTool& c) const {
    if (c.tool == Tool::draw && walkthrough_is_open(state)) close_walkthrough(state);
    state.tool = c.tool;
    browser::summary_changed();
    state.explanation.reset();
    if (!state.drawing.points.empty()) browser::document_changed();
    state.drawing = {};
    state.selected.reset();
    state.hover = state.held = {};
    if (c.tool == Tool::draw) state.second_method.reset();
    show(state, {});
  }
  void operator()(const GripPolygon&) const {
    state.grip = {state.document.vertices, state.document.centre_of_mass};
  }
  void operator()(const AddPoint& c) const { add_point(state, c.at); }
  void operator()(const MovePoint& c) const {
    Points& points = state.drawing.points;
    if (c.point >= points.size() || points[c.point] == c.to) return;
    points[c.point] = c.to;
    renew_drawing(state);
  }
  void operator()(const TakePointBack&) const {
    Drawing& drawing = state.drawing;
    if (drawing.points.empty()) return;
    drawing.undone.push_back(drawing.points.back());
    drawing.points.pop_back();
    renew_drawing(state);
  }
  void operator()(const PutPointBack&) const {
    Drawing& drawing = state.drawing;
    if (drawing.undone.empty()) return;
    drawing.points.push_back(drawing.undone.back());
    drawing.undone.pop_back();
    renew_drawing(state);
  }
  void operator()(const FinishDrawing&) const { finish_drawing(state); }
  void operator()(const OpenWalkthrough&) const {
    put_teams_back(state);
    open_walkthrough(state);
  }
  void operator()(const CloseWalkthrough&) const { leave_lesson(state); }
  void operator()(const GoToStep& c) const { go_to_step(state, c.step); }
  void operator()(const MoveSteps& c) const { move_steps(state, c.by); }
  void operator()(const MoveChapters& c) const { move_chapters(state, c.by); }
  void operator()(const SetPlaying& c) const { set_playing(state, c.playing); }
  void operator()(const SetSpeed& c) const { set_speed(state, c.speed); }
  void operator()(const SetPredict& c) const { set_predict(state, c.on); }
  void operator()(const Guess& c) const { guess(state, c.answer); }
  void operator()(const PointAtChoice& c) const {
    if (state.walkthrough.ask) state.walkthrough.ask->pointed = c.choice;
  }
  void operator()(const AskWhy& c) const { ask_why(state, c.at); }
  void operator()(const Measure& c) const { measure(state, c.candidate); }
  void operator()(const HoverFigure& c) const { state.walkthrough.hovered = c.figure; }
  void operator()(const Explain& c) const {
    state.explanation.reset();
    if (!c.of || state.refusal || !state.placement) return;
    state.explanation = explain(state, *c.of);
    browser::announce(in_words(*state.explanation));
  }
  void operator()(const ShowInLesson& c) const {
    state.explanation.reset();
    if (walkthrough_is_open(state))
      go_to_step(state, c.step);
    else
      open_walkthrough(state, c.step);
  }
  void operator()(const LeaveScript&) const { leave_script(state); }
  void operator()(const ShowAllSteps& c) const { show_all_steps(state, c.all); }
  void operator()(const SetPresenting& c) const {
    if (c.on && !walkthrough_is_open(state)) put_teams_back(state);
    if (c.on) open_walkthrough(state);
    state.presenting = c.on && walkthrough_is_open(state);
    browser::show_full_screen(state.presenting);
  }
  void operator()(const SetDrawCursor& c) const {
    Drawing& drawing = state.drawing;
    drawing.cursor = c.at;
    if (c.at) drawing.last_cursor = c.at;
    if (c.by_keys)
      keep_in_sight(state, *c.at);
    else
      drawing.pointer = c.pointer;
    if (c.by_keys || drawing.by_keys) browser::summary_changed();
    drawing.by_keys = c.by_keys;
    if (c.at && closes(state, state.camera.to_screen(*c.at))) check_drawing(drawing);
  }
  void operator()(const TypeEdge& c) const { type_edge(state, c); }
  void operator()(const SetSnap& c) const {
    // Where no bar shows it, a notice does.
    if (state.tool == Tool::parts && !state.selected && !(c.snap == state.snap)) {
      const bool grid = c.snap.grid != state.snap.grid, on = grid ? c.snap.grid : c.snap.axis;
      std::string words =
          on ? "What is dragged now snaps to the " : "What is dragged no longer snaps to the ";
      words += grid ? "grid." : "axis through a neighbour.";
      show(state, {Notice::Kind::info, std::move(words)});
    }
    state.snap = c.snap;
    browser::summary_changed();
  }
  void operator()(const Compare& c) const {
    const std::optional<Method> second =
        c.method == state.document.settings.method ? std::nullopt : c.method;
    if (second == state.second_method) return;
    begin_edit(state, false, Edit::comparison);
    state.second_method = second;
    state.hover = state.held = {};
    follow_up(state);
    ++state.revision;
    browser::document_changed();  // there is one more step of undo to be kept
  }
  void operator()(const Fail& c) const { let_fail(state, c.robot); }
  void operator()(const SetLoadModel& c) const {
    if (c.model == state.load_model) return;
    state.load_model = c.model;
    renew_outlook(state);
    browser::summary_changed();
  }
  void operator()(const SetCapacity& c) const {
    if (settings(state).capacity == c.capacity) return;
    change_beside(state, false, Edit::capacity, [&](Settings& s) { s.capacity = c.capacity; });
  }
  void operator()(const SetComRadius& c) const {
    if (settings(state).com_radius == c.radius) return;
    change_beside(state, c.live, Edit::com_radius, [&](Settings& s) { s.com_radius = c.radius; });
  }
  void operator()(const SetUnits& c) const {
    if (settings(state).units == c.units) return;
    change_beside(state, false, Edit::settings, [&](Settings& s) { s.units = c.units; });
  }
  void operator()(const SetMotion& c) const {
    state.motion = c.on;
    browser::preferences_changed();
  }

  void operator()(const SelectVertex& c) const {
    if (state.selected != c.vertex) browser::summary_changed();
    state.selected = c.vertex;
    drop_stale_picks(state);
  }
  void operator()(const SetHover& c) const { state.hover = c.pick; }
  void operator()(const SetHeld& c) const {
    state.held = c.pick;
    state.closed_to.reset();
  }
  void operator()(const SetCamera& c) const {
    const double fitting = fitting_camera(state).scale;
    state.camera = c.camera;
    state.camera.scale =
        std::clamp(c.camera.scale, fitting * smallest_zoom, fitting * largest_zoom);
    state.camera_follows = false;
  }
  void operator()(const FitView&) const { fit_view(state); }
  void operator()(const ZoomView& c) const {
    zoom_view(state, layout(state).room.middle(), c.factor);
  }
  void operator()(const SetPanelOpen& c) const { state.panel_open = c.open; }
  void operator()(const SetMoreOpen& c) const { state.more_open = c.open; }
  void operator()(const SetRobotOpen& c) const { state.robot_open = c.open; }
  void operator()(const SetErases& c) const { state.erases = c.erases; }
  void operator()(const ListIsOpen& c) const {
    state.list_open = c.open;
    state.close_list = state.close_list && c.open;
  }
  void operator()(const CloseList&) const { state.close_list = true; }
  void operator()(const SetSheet& c) const { state.sheet = c.sheet; }
  void operator()(const MeasureSheet& c) const { state.closed_sheet_height = c.closed_height; }
  void operator()(const CopyLink&) const {
    const Result<std::string> link = encode_link(state.placed);
    if (link) {
      browser::copy_address(*link);
    } else {
      show(state, {Notice::Kind::problem, sentence(link.error()) + "."});
    }
  }
  void operator()(const TypeValue& c) const { browser::type_value(c.control); }
  void operator()(const OpenDialog& c) const { browser::open_dialog(c.dialog); }
  void operator()(const ShowNotice& c) const { show(state, c.notice); }
};

}  // namespace

void lay_behind(AppState& state, const std::optional<Box>& picture) {
  state.backdrop = picture;
  if (!picture) return;
  if (state.tool != Tool::draw) {
    Commands commands{SetTool{Tool::draw}};
    apply(state, commands);
  }
  state.camera = fitting_camera(state);
  state.camera_follows = false;
}

bool apply(AppState& state, Commands& commands) {
  if (commands.empty()) return false;
  for (Command& command : commands) std::visit(Applier{state}, command);
  commands.clear();
  return true;
}

void frame_view(AppState& state) {
  // A polygon that is being drawn must not move under the hand.
  if (!state.camera_follows || state.edit_open || state.tool == Tool::draw) return;
  const Rect room = layout(state).room;
  if (!state.fit_due && room == state.fitted) return;
  state.camera = fitting_camera(state);
  state.fitted = room;
  state.fit_due = false;
}

void start_with(AppState& state, Opened opened, const std::optional<Document>& work) {
  if (work) {
    state.document = *work;
    open(state, std::move(opened));
  } else {
    show_opened(state, std::move(opened));
  }
}

void reopen(AppState& state, Opened opened) { show_opened(state, std::move(opened)); }

void resume_draft(AppState& state, Document draft) {
  begin_edit(state, false, Edit::vertex_moved);
  forget_former(state);
  state.document = std::move(draft);
  recompute(state);
}

namespace {

// Whether only what places nothing differs in the edited document.
bool places_nothing(const AppState& state, const Document& edited) {
  const Settings but = placing_as(edited.settings, settings(state));
  return !state.refusal && edited.vertices == state.document.vertices &&
         edited.centre_of_mass == state.document.centre_of_mass && but == settings(state);
}

// Goes to another step of the open document's walkthrough, or closes the walkthrough.
std::optional<InputError> try_step(AppState& state, std::optional<std::uint32_t> step) {
  std::optional<Trace> made;
  if (step && !walkthrough_is_open(state)) {
    put_teams_back(state);
    Result<Trace> trace = compute_trace(*state.placement);
    if (!trace) return trace.error();
    made = std::move(trace).value();
  }
  if (step) {
    if (const auto problem = check_step(*step, made ? *made : *state.walkthrough.trace))
      return problem;
  }
  if (step && !made) {
    go_to_step(state, *step);
    return std::nullopt;
  }
  state.document.settings.step = state.placed.settings.step = step;
  follow_placement(state, std::move(made));
  return std::nullopt;
}

}  // namespace

std::optional<InputError> try_edit(AppState& state, const Document& edited, std::uint64_t failed) {
  if (places_nothing(state, edited)) {
    if (const auto problem = check_robot(*state.placement, failed)) return problem;
    if (const auto problem = try_step(state, edited.settings.step)) return problem;
    const Settings &before = settings(state), &after = edited.settings;
    if (before.capacity == after.capacity && before.com_radius == after.com_radius &&
        before.units == after.units)
      return std::nullopt;
    change_beside(state, false, edit_between(before, after), [&](Settings& s) {
      s.capacity = after.capacity;
      s.com_radius = after.com_radius;
      s.units = after.units;
    });
    return std::nullopt;
  }
  Result<Placement> placement = compute_placement(edited, state.placement);
  if (!placement) return placement.error();
  if (const auto problem = check_robot(*placement, failed)) return problem;
  std::optional<Trace> trace;
  if (edited.settings.step) {
    Result<Trace> made = compute_trace(*placement);
    if (!made) return made.error();
    if (auto problem = check_step(*edited.settings.step, *made)) return problem;
    trace = std::move(made).value();
  }
  begin_edit(state, false, edit_between(settings(state), edited.settings));
  state.document = edited;
  adopt(state, std::move(placement));
  follow_up(state);
  follow_placement(state, std::move(trace));
  return std::nullopt;
}

}  // namespace evenlift::view
