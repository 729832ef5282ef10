#include "app/update.h"

#include <algorithm>
#include <utility>

#include "evenlift/link.h"
#include "evenlift/output/words.h"
#include "state/browser.h"
#include "state/layout.h"
#include "state/opened.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

constexpr double largest_zoom =
    1000;  // times the view that fits: screen coordinates stay fit for floats
constexpr double smallest_zoom = 0.05;

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
  part_methods(state, state.placed.settings.method);
  const std::string before = state.refusal ? sentence(*state.refusal) : std::string();
  if (placement) {
    state.plan_due |= !state.placement || !same_plan(*state.placement, *placement);
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

// Computes what is shown beside the placement. The capacity plan is computed only if it can have
// changed, and not during a drag, when nobody reads it.
void follow_up(AppState& state) {
  if (state.refusal) return;
  state.second.reset();
  if (state.second_method) {
    Document document = state.placed;
    document.settings.method = *state.second_method;
    // Methods that do not choose among candidates cannot take all of them.
    const bool all = !document.settings.teams;
    if (all)
      document.settings.teams =
          static_cast<std::uint32_t>(std::max<std::size_t>(state.placement->teams.size(), 1));
    if (Result<Placement> placement = compute_placement(document))
      state.second = std::move(placement).value();
  }
  if (state.edit_open || !state.plan_due) return;
  state.plan.reset();
  if (state.capacity) state.plan = plan_capacity(*state.placement, *state.capacity);
  state.plan_due = false;
}

void recompute(AppState& state) {
  adopt(state, compute_placement(state.document));
  follow_up(state);
  follow_placement(state);
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

void begin_edit(AppState& state, bool live) {
  if (live && state.edit_open) return;
  state.history.record(state.document);
  state.edit_open = live;
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
  state.walkthrough.at = 0;
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

void open(AppState& state, Opened opened) {
  begin_edit(state, false);
  show_opened(state, std::move(opened));
}

// Opens the polygon that was drawn, with the present settings.
void finish_drawing(AppState& state) {
  Document drawn;
  drawn.vertices = state.drawing.points;
  drawn.settings = state.document.settings;
  drawn.settings.step.reset();
  Result<Opened> polygon = opened(std::move(drawn));
  if (!polygon) {
    show(state, {Notice::Kind::problem, sentence(polygon.error()) + "."});
    return;
  }
  open(state, std::move(polygon).value());
}

// Whether the camera shows all vertices, and not much smaller than they could be.
bool well_shown(const AppState& state) {
  const Screen& screen = state.screen;
  const double best = fit(state.document.vertices, layout(state).room).scale;
  if (state.camera.scale < best * 0.4) return false;
  const Rect window{0, 0, screen.width, screen.height};
  return std::all_of(state.document.vertices.begin(), state.document.vertices.end(),
                     [&](const Vec2& p) { return window.contains(state.camera.to_screen(p)); });
}

void step_back(AppState& state, Document document) {
  const bool other_shape = document.vertices.size() != state.document.vertices.size();
  state.edit_open = false;
  // The step of the walkthrough is not undone, except when undo leaves a script: then the former
  // step comes back.
  if (state.walkthrough.script && state.history.depth() < state.walkthrough.script->depth)
    state.walkthrough.script.reset();
  else
    document.settings.step = state.document.settings.step;
  document.settings.overlays = state.document.settings.overlays;  // neither are the overlays
  state.document = std::move(document);
  if (other_shape) state.selected.reset();
  drop_stale_picks(state);
  if (state.camera_follows && !well_shown(state)) state.fit_due = true;
  recompute(state);
}

void zoom_view(AppState& state, const Vec2& about, double factor) {
  const double fitting = fit(state.document.vertices, layout(state).room).scale;
  state.camera = zoom(state.camera, about, factor, fitting * smallest_zoom, fitting * largest_zoom);
  state.camera_follows = false;
}

struct Applier {
  AppState& state;

  void operator()(const SetSettings& c) const {
    if (c.settings == state.document.settings) return;
    begin_edit(state, c.live);
    state.document.settings = c.settings;
    recompute(state);
  }
  void operator()(const MoveVertex& c) const {
    if (c.vertex >= state.document.vertices.size() || state.document.vertices[c.vertex] == c.to)
      return;
    begin_edit(state, true);
    state.document.vertices[c.vertex] = c.to;
    recompute(state);
  }
  void operator()(const MoveCentre& c) const {
    if (state.document.centre_of_mass == c.to) return;
    begin_edit(state, true);
    state.document.centre_of_mass = c.to;
    recompute(state);
  }
  void operator()(const ReleaseCentre&) const {
    if (!state.document.centre_of_mass) return;
    begin_edit(state, false);
    state.document.centre_of_mass.reset();
    recompute(state);
  }
  void operator()(const InsertVertex& c) const {
    Points& vertices = state.document.vertices;
    if (c.edge >= vertices.size()) return;
    begin_edit(state, false);
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
    begin_edit(state, false);
    vertices.erase(vertices.begin() + static_cast<std::ptrdiff_t>(c.vertex));
    state.selected.reset();
    state.hover = state.held = {};
    recompute(state);
  }
  void operator()(OpenDocument& c) const { open(state, std::move(c.opened)); }
  void operator()(const SetPolygon& c) const {
    if (c.vertices == state.document.vertices) return;
    begin_edit(state, c.live);
    state.document.vertices = c.vertices;
    state.document.centre_of_mass = c.centre_of_mass;
    recompute(state);
  }
  void operator()(const EndEdit&) const {
    if (!state.edit_open) return;
    state.edit_open = false;
    follow_up(state);
  }
  void operator()(const Undo&) const {
    if (state.history.can_undo()) step_back(state, state.history.undo(state.document));
  }
  void operator()(const Redo&) const {
    if (state.history.can_redo()) step_back(state, state.history.redo(state.document));
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
  void operator()(const AddPoint& c) const {
    Points& points = state.drawing.points;
    if (!points.empty() && points.back() == c.at) return;
    points.push_back(c.at);
    state.drawing.undone.clear();
    show(state, {});
    browser::document_changed();
  }
  void operator()(const TakePointBack&) const {
    Drawing& drawing = state.drawing;
    if (drawing.points.empty()) return;
    drawing.undone.push_back(drawing.points.back());
    drawing.points.pop_back();
    show(state, {});
    browser::document_changed();
  }
  void operator()(const PutPointBack&) const {
    Drawing& drawing = state.drawing;
    if (drawing.undone.empty()) return;
    drawing.points.push_back(drawing.undone.back());
    drawing.undone.pop_back();
    browser::document_changed();
  }
  void operator()(const FinishDrawing&) const { finish_drawing(state); }
  void operator()(const OpenWalkthrough&) const { open_walkthrough(state); }
  void operator()(const CloseWalkthrough&) const { close_walkthrough(state); }
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
  void operator()(const LeaveScript&) const { leave_script(state); }
  void operator()(const SetDrawCursor& c) const { state.drawing.cursor = c.at; }
  void operator()(const SetSnap& c) const { state.snap = c.snap; }
  void operator()(const Compare& c) const {
    state.second_method = c.method == state.document.settings.method ? std::nullopt : c.method;
    state.hover = state.held = {};
    follow_up(state);
    ++state.revision;
  }
  void operator()(const SetCapacity& c) const {
    if (state.capacity == c.capacity) return;
    state.capacity = c.capacity;
    state.plan_due = true;
    follow_up(state);
    browser::preferences_changed();
  }
  void operator()(const SetMotion& c) const {
    state.motion = c.on;
    browser::preferences_changed();
  }

  void operator()(const SelectVertex& c) const {
    state.selected = c.vertex;
    drop_stale_picks(state);
  }
  void operator()(const SetHover& c) const { state.hover = c.pick; }
  void operator()(const SetHeld& c) const { state.held = c.pick; }
  void operator()(const SetCamera& c) const {
    const double fitting = fit(state.document.vertices, layout(state).room).scale;
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
  void operator()(const SetHelpOpen& c) const { state.help_open = c.open; }
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
  void operator()(const OpenDialog& c) const { browser::open_dialog(c.dialog); }
  void operator()(const ShowNotice& c) const { show(state, c.notice); }
};

}  // namespace

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
  state.camera = fit(state.document.vertices, room);
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

void resume_draft(AppState& state, Document draft) {
  begin_edit(state, false);
  forget_former(state);
  state.document = std::move(draft);
  recompute(state);
}

namespace {

// Whether only the step of the walkthrough differs in the edited document.
bool only_steps(const AppState& state, const Document& edited) {
  Settings but_step = edited.settings;
  but_step.step = state.document.settings.step;
  return !state.refusal && edited.vertices == state.document.vertices &&
         edited.centre_of_mass == state.document.centre_of_mass &&
         but_step == state.document.settings;
}

// Goes to another step of the open document's walkthrough, or closes the walkthrough.
std::optional<InputError> try_step(AppState& state, std::optional<std::uint32_t> step) {
  std::optional<Trace> made;
  if (step && !walkthrough_is_open(state)) {
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

std::optional<InputError> try_edit(AppState& state, const Document& edited) {
  if (only_steps(state, edited)) return try_step(state, edited.settings.step);
  Result<Placement> placement = compute_placement(edited);
  if (!placement) return placement.error();
  std::optional<Trace> trace;
  if (edited.settings.step) {
    Result<Trace> made = compute_trace(*placement);
    if (!made) return made.error();
    if (auto problem = check_step(*edited.settings.step, *made)) return problem;
    trace = std::move(made).value();
  }
  begin_edit(state, false);
  state.document = edited;
  adopt(state, std::move(placement));
  follow_up(state);
  follow_placement(state, std::move(trace));
  return std::nullopt;
}

}  // namespace evenlift::view
