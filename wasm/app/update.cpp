#include "app/update.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "edits/by_hand.h"
#include "edits/changed_settings.h"
#include "edits/draw_polygon.h"
#include "edits/open_document.h"
#include "edits/outlook.h"
#include "edits/placing.h"
#include "edits/sight.h"
#include "edits/undo.h"
#include "edits/vertices.h"
#include "evenlift/link.h"
#include "evenlift/moved.h"
#include "evenlift/output/words.h"
#include "state/browser.h"
#include "state/layout.h"
#include "state/method.h"
#include "state/notice.h"
#include "state/screen.h"
#include "state/seen.h"
#include "walkthrough/ask_why.h"
#include "walkthrough/explain.h"
#include "walkthrough/playing.h"
#include "walkthrough/questions.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// During a drag the walkthrough shows only the start of a search for balanced robots.
void trace_whole_search(AppState& state) {
  const std::optional<Trace>& trace = state.walkthrough.trace;
  if (trace && trace->balanced() && !trace->placement.search_ended) follow_placement(state);
}

// Opens the steps of the object itself, if none are open.
void open_own_steps(AppState& state, std::optional<std::uint32_t> at = std::nullopt) {
  if (!walkthrough_is_open(state)) state.walkthrough.of_lesson = false;
  open_walkthrough(state, at);
}

struct Applier {
  AppState& state;

  void operator()(const SetSettings& c) const {
    if (c.settings == state.document.settings) return;
    begin_edit(state, c.live, edit_between({{}, {}, settings(state)}, {{}, {}, c.settings}));
    const bool robots_stay = stand_alike(c.settings, settings(state));
    state.document.settings = c.settings;
    recompute(state, robots_stay);
  }
  void operator()(const SetMethod& c) const {
    auto [changed, aside] =
        with_method(settings(state), c.method, placed_teams(state), std::move(state.aside));
    state.aside = std::move(aside);
    (*this)(SetSettings{std::move(changed)});
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
  void operator()(const InsertVertex& c) const { insert_vertex(state, c.edge, c.at); }
  void operator()(const RemoveVertex& c) const { remove_vertex(state, c.vertex); }
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
  void operator()(const MoveRobot& c) const { move_robot(state, c.robot, c.to); }
  void operator()(const ResetRobots&) const { put_robots_back(state); }
  void operator()(const Undo&) const { undo(state); }
  void operator()(const Redo&) const { redo(state); }

  // Other units are told, since no number changes with them.
  void operator()(const SetShown& c) const {
    const Units before = shown(state).units, &now = c.shown.units;
    change_shown(state, shown(state), c.shown, c.live);
    if (now == before) return;
    const bool lengths = now.length != before.length, none = now.length == LengthUnit::none;
    const std::string what = lengths ? "Lengths are now " : "Weights are now ",
                      unit{lengths ? name(now.length) : name(now.weight)};
    show(state, {Notice::Kind::info, what + (lengths && none ? "without a unit" : "in " + unit) +
                                         ". Their numbers stay as they are."});
  }
  void operator()(const SetTool& c) const { take_tool(state, c.tool); }
  void operator()(const GripPolygon&) const {
    state.grip = {state.document.vertices, state.document.centre_of_mass};
  }
  void operator()(const AddPoint& c) const { add_point(state, c.at); }
  void operator()(const MovePoint& c) const { move_point(state, c.point, c.to); }
  void operator()(const TakePointBack&) const { take_point_back(state); }
  void operator()(const PutPointBack&) const { put_point_back(state); }
  void operator()(const FinishDrawing&) const { finish_drawing(state); }
  void operator()(const OpenWalkthrough&) const {
    put_teams_back(state);
    open_own_steps(state);
  }
  void operator()(const CloseWalkthrough&) const { leave_walkthrough(state); }
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
  void operator()(const AskWhy& c) const {
    if (c.at)
      ask_why(state, *c.at);
    else
      forget_why(state.walkthrough);
  }
  void operator()(const Measure& c) const { measure(state, c.candidate); }
  void operator()(const HoverFigure& c) const { state.walkthrough.hovered = c.figure; }
  void operator()(const Explain& c) const {
    state.explanation.reset();
    if (!c.of || state.refusal || !state.placement) return;
    state.explanation = explain(state, *c.of);
    // What a finger pressed may have been a vertex beside it.
    if (state.screen.touch) state.hover = {};
    browser::announce(in_words(*state.explanation));
  }
  void operator()(const ShowInLesson& c) const {
    state.explanation.reset();
    if (walkthrough_is_open(state))
      go_to_step(state, c.step);
    else
      open_own_steps(state, c.step);
  }
  void operator()(const LeaveScript&) const { leave_script(state); }
  void operator()(const ShowAllSteps& c) const { show_all_steps(state, c.all); }
  void operator()(const SetPresenting& c) const {
    if (c.on && !walkthrough_is_open(state)) put_teams_back(state);
    if (c.on) open_own_steps(state);
    set_presenting(state, c.on && walkthrough_is_open(state));
  }
  void operator()(const SetDrawCursor& c) const { set_draw_cursor(state, c); }
  void operator()(const TypeEdge& c) const { type_edge(state, c); }
  void operator()(const WithdrawEdge&) const { withdraw_edge(state); }
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
  void operator()(const SetMotion& c) const {
    state.motion = c.on;
    browser::announce(c.on ? "Motion is on." : "Motion is off.");
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
  void operator()(const SetCamera& c) const { look_through(state, c.camera); }
  void operator()(const FitView&) const {
    fit_view(state);
    browser::announce("All of the object is in view.");
  }
  void operator()(const ZoomView& c) const {
    zoom_view(state, c.about.value_or(layout(state).room.middle()), c.factor);
    if (!c.about)  // by a key or a button
      browser::announce("Zoom: " + zoom_in_words(state) + " of the view that fits.");
  }
  void operator()(const SetPanelOpen& c) const {
    if (c.open != state.panel_open)
      browser::announce(c.open ? "The panel is open." : "The panel is folded away.");
    state.panel_open = c.open;
  }
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
  void operator()(const MeasureNotice& c) const { state.notice_height = c.height; }
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

bool apply(AppState& state, Commands& commands) {
  if (commands.empty()) return false;
  for (Command& command : commands) std::visit(Applier{state}, command);
  commands.clear();
  return true;
}

}  // namespace evenlift::view
