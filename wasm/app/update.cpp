#include "app/update.h"

#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include "edits/undo.h"
#include "edits/vertices.h"
#include "evenlift/link.h"
#include "evenlift/moved.h"
#include "evenlift/output/words.h"
#include "evenlift/placement.h"
#include "evenlift/settings.h"
#include "evenlift/similar_setting.h"
#include "evenlift/wording.h"
#include "state/command.h"
#include "state/layout.h"
#include "state/method.h"
#include "state/screen.h"
#include "tools/picture_marks.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

std::shared_ptr<AnyCommand> Command::owned(AnyCommand* command) {
  return std::shared_ptr<AnyCommand>(command);
}

namespace {

template <class Value, class Read>
std::optional<InputError> take(Setting setting, const Read& read, Value& value) {
  if (!read) return setting_error(setting);
  value = *read;
  return std::nullopt;
}

std::optional<InputError> read(Setting setting, std::string_view text, Changeable& changed) {
  switch (setting) {
    case Setting::loads:
      return take(setting, load_model_from_name(text), changed.load_model);
    case Setting::failed:
      return take(setting, read_failed(text), changed.failed);
    default:
      return read_setting(setting, text, changed.document);
  }
}

}  // namespace

Result<Changeable> with_settings(Changeable given, std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    const std::size_t equals = line.find('=');
    const std::string_view name = line.substr(0, equals);
    const std::optional<Setting> setting = setting_from_name(name);
    if (!setting || equals == std::string_view::npos)
      return InputError{ErrorCode::bad_setting,
                        unknown_setting(name),
                        {Place::Kind::option, 0, 0, std::string(name)}};
    if (auto error = read(*setting, line.substr(equals + 1), given)) return *error;
  }
  if (const auto error = check_settings(given.document.settings, given.document.shown))
    return *error;
  return given;
}

std::string kept_text(const Kept& kept) { return kept.motion ? "motion=1\n" : "motion=0\n"; }

Kept read_kept(std::string_view lines) {
  Kept kept;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    if (line.starts_with("motion=")) kept.motion = line != "motion=0";
  }
  return kept;
}

namespace {

void open_own_steps(AppState& state, std::optional<std::uint32_t> at = std::nullopt) {
  if (!walkthrough_is_open(state)) state.view.walkthrough.of_lesson = false;
  open_walkthrough(state, at);
}

struct Applier {
  AppState& state;

  void operator()(const SetSettings& c) const {
    if (c.settings == state.work.document().settings) return;
    const bool robots_stay = stand_alike(c.settings, settings(state));
    const Moved moved = robots_stay ? state.work.document().moved : Moved{};
    const Edit what = edit_between({{}, {}, settings(state)}, {{}, {}, c.settings});
    Document& document = edit(state, c.live, what);
    document.settings = c.settings;
    document.moved = moved;
  }
  void operator()(const SetMethod& c) const {
    if (c.method == Method::given) {
      if (!state.derived().placement) return;
      if (settings(state).method != Method::given) state.work.aside.method = settings(state).method;
      (*this)(SetSettings{taken_over(settings(state), *state.derived().placement)});
      return;
    }
    auto [changed, aside] =
        with_method(settings(state), c.method, placed_teams(state), std::move(state.work.aside));
    state.work.aside = std::move(aside);
    // As many balanced robots as stood there by hand.
    if (settings(state).method == Method::given && c.method == Method::balanced)
      changed.robots = std::clamp(static_cast<std::uint32_t>(settings(state).supports.size()),
                                  fewest_robots(changed), most_robots);
    (*this)(SetSettings{std::move(changed)});
  }
  void operator()(const MoveVertex& c) const { move_handle(state, c.vertex, c.to); }
  void operator()(const MoveCentre& c) const {
    if (state.work.document().centre_of_mass == c.to) return;
    edit(state, true, Edit::centre_moved).centre_of_mass = c.to;
  }
  void operator()(const ReleaseCentre&) const {
    if (!state.work.document().centre_of_mass) return;
    edit(state, false, Edit::centre_released).centre_of_mass.reset();
  }
  void operator()(const InsertVertex& c) const { insert_vertex(state, c.edge, c.at); }
  void operator()(const RemoveVertex& c) const { remove_handle(state, c.vertex); }
  void operator()(const AddWeight& c) const { add_weight(state, c.at); }
  void operator()(const SetCargo& c) const { set_weight(state, c.item, c.cargo); }
  void operator()(OpenDocument& c) const { open(state, std::move(c.opened)); }
  void operator()(const SetPolygon& c) const {
    if (c.shape.vertices == state.work.document().vertices) return;
    Document& document = edit(state, c.live, Edit::whole);
    document.vertices = c.shape.vertices;
    document.centre_of_mass = c.shape.centre_of_mass;
    document.holes = c.shape.holes;
    document.settings.cargo = c.shape.cargo;
    document.settings.supports = c.shape.supports;
  }
  void operator()(const EndEdit&) const {
    take_away_dragged_out(state);
    if (!state.work.edit_open) return;
    state.work.edit_open = false;
    if (state.view.camera_follows && !(centre_is_shown(state) && vertices_are_shown(state)))
      state.view.fit_due = true;
  }
  void operator()(const MoveRobot& c) const {
    if (lags(state)) return;  // the robot belongs to an older shape
    const auto& placement = state.derived().placement;
    if (placement && stands_freely(*placement))
      move_support(state, c.robot, c.to);
    else
      move_robot(state, c.robot, c.to);
  }
  void operator()(const PlaceYourself& c) const { place_yourself(state, c.robots); }
  void operator()(const CloseTask&) const { leave_task(state); }
  void operator()(const SetChallenge& c) const { state.view.challenge = c.on; }
  void operator()(const AddRobot& c) const { add_support(state, c.at); }
  void operator()(const PutRobot& c) const { put_support(state, c.robot, c.at); }
  void operator()(const RemoveRobot& c) const { remove_support(state, c.robot); }
  void operator()(const EvenOut&) const { even_out_supports(state); }
  void operator()(SetReadings& c) const {
    edit(state, false, edit_of(row_of(Setting::readings))) = std::move(c.document);
  }
  void operator()(const NameRobot& c) const { name_support(state, c.robot, c.name); }
  void operator()(const TakeOver&) const {
    const auto& placement = state.derived().placement;
    if (!placement || !placement->weighing || lags(state)) return;
    Document own = evenlift::taken_over(state.work.document(), *placement->weighing);
    edit(state, false, edit_of(row_of(Setting::readings))) = std::move(own);
    show(state,
         {Notice::Kind::info,
          say("The weight and C are the object's now, without the readings. Undo brings them "
              "back.")});
  }
  void operator()(const ResetRobots&) const { put_robots_back(state); }
  void operator()(TakeRobots& c) const {
    const Search& search = state.derived().search;
    if (!c.robots && search.under_way && search.number == c.number)
      show(state,
           {Notice::Kind::problem,
            "The search for better places stopped: a part of the page could not be loaded."});
    state.given.found = {c.number, std::move(c.robots), c.ended, c.cut_short};
  }
  void operator()(TakeChoice& c) const { state.given.chosen = {c.number, std::move(c.choice)}; }
  void operator()(const Undo&) const { undo(state); }
  void operator()(const Redo&) const { redo(state); }

  // A notice reports new units, since they change no number.
  void operator()(const SetShown& c) const {
    const Units before = shown(state).units, &now = c.shown.units;
    change_shown(state, shown(state), c.shown, c.live);
    if (now == before) return;
    const bool lengths = now.length != before.length, none = now.length == LengthUnit::none;
    show(
        state,
        {Notice::Kind::info,
         !lengths ? say("Weights are now in {unit}. The numbers stay the same.", {name(now.weight)})
         : none
             ? say("Lengths are now without a unit. The numbers stay the same.")
             : say("Lengths are now in {unit}. The numbers stay the same.", {name(now.length)})});
  }
  void operator()(const SetTool& c) const { take_tool(state, c.tool); }
  void operator()(const GripPolygon&) const { grip_polygon(state); }
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
    if (state.view.walkthrough.ask) state.view.walkthrough.ask->pointed = c.choice;
  }
  void operator()(const AskWhy& c) const {
    if (c.at)
      ask_why(state, *c.at);
    else
      forget_why(state.view.walkthrough);
  }
  void operator()(const Measure& c) const { measure(state, c.candidate); }
  void operator()(const HoverFigure& c) const { state.view.walkthrough.hovered = c.figure; }
  void operator()(const Explain& c) const {
    state.view.card.ask(c.of);
    // The finger may also have pressed a vertex nearby.
    if (c.of && state.session.screen.touch) state.view.hover = {};
  }
  void operator()(const ShowInLesson& c) const {
    state.view.card.ask(std::nullopt);
    if (walkthrough_is_open(state))
      go_to_step(state, c.step);
    else
      open_own_steps(state, c.step);
  }
  void operator()(const LeaveScript&) const { leave_script(state); }
  void operator()(const ShowAllSteps& c) const { show_all_steps(state, c.all); }
  void operator()(const SetPresenting& c) const { set_presenting(state, c.on); }
  void operator()(const SetDrawCursor& c) const { set_draw_cursor(state, c); }
  void operator()(const TypeEdge& c) const { type_edge(state, c); }
  void operator()(const WithdrawEdge&) const { withdraw_edge(state); }
  void operator()(const SetSnap& c) const {
    // If no bar shows the change, a notice does.
    if (state.view.tool == Tool::parts && !state.view.selected && !(c.snap == state.view.snap)) {
      const bool grid = c.snap.grid != state.view.snap.grid, on = grid ? c.snap.grid : c.snap.axis;
      show(state,
           {Notice::Kind::info,
            grid ? (on ? "Points now snap to the grid." : "Points no longer snap to the grid.")
            : on ? "Points now snap to the axis through a neighbour."
                 : "Points no longer snap to the axis through a neighbour."});
    }
    state.view.snap = c.snap;
    emit(state, SummaryChanged{});
  }
  void operator()(const Compare& c) const {
    const std::optional<Method> second =
        c.method == state.work.document().settings.method ? std::nullopt : c.method;
    if (second == state.work.second_method) return;
    begin_edit(state, false, Edit::comparison);
    state.work.second_method = second;
    state.view.hover = state.view.held = {};
    emit(state, DocumentChanged{});  // storage keeps the step of undo
  }
  void operator()(const Fail& c) const {
    const Derived& facts = state.derived();
    if (!facts.placement || facts.refusal) return;
    if (c.robot && *c.robot >= count_robots(facts.placement->teams)) return;
    if (c.robot ? facts.failure && facts.failure->robot == *c.robot : !facts.failure) return;
    if (!c.robot)
      announce(state,
               say("Robot {robot} works again.", {facts.placement->called(facts.failure->robot)}));
    state.view.fails.ask(c.robot);
  }
  void operator()(const SetLoadModel& c) const {
    if (c.model == state.view.load_model) return;
    state.view.load_model = c.model;
    emit(state, SummaryChanged{});
  }
  void operator()(const SetMotion& c) const {
    state.view.motion = c.on;
    announce(state, c.on ? "Motion is on." : "Motion is off.");
    emit(state, PreferencesChanged{});
  }

  void operator()(const SelectVertex& c) const {
    if (state.view.selected != c.vertex) emit(state, SummaryChanged{});
    state.view.selected = c.vertex;
    drop_stale_picks(state);
  }
  void operator()(const SetHover& c) const { state.view.hover = c.pick; }
  void operator()(const SetHeld& c) const {
    state.view.held = c.pick;
    state.view.closed_to.reset();
  }
  void operator()(const SetCamera& c) const { look_through(state, c.camera); }
  void operator()(const FitView&) const {
    fit_view(state);
    announce(state, "The whole object is in view.");
  }
  void operator()(const ZoomView& c) const {
    zoom_view(state, c.about.value_or(layout(state).room.middle()), c.factor);
    if (!c.about)  // by a key or a button
      announce(state, say("Zoom: {zoom} of the view that fits.", {zoom_in_words(state)}));
  }
  void operator()(const SetPanelOpen& c) const {
    if (c.open != state.view.panel_open)
      announce(state, c.open ? "The panel is open." : "The panel is folded away.");
    state.view.panel_open = c.open;
  }
  void operator()(const SetSectionOpen& c) const { state.view.*c.section = c.open; }
  void operator()(const SetDrawerOpen& c) const {
    state.view.open_drawers[static_cast<std::size_t>(c.drawer)] = c.open;
  }
  void operator()(const ExplainMark& c) const {
    state.view.explained = c.mark;
    if (const auto mark = explained_mark(state)) announce(state, mark_in_words(state, *mark));
  }
  void operator()(const ForgetField&) const { state.session.wanted_field.clear(); }
  void operator()(const SetErases& c) const { state.view.erases = c.erases; }
  void operator()(const ListIsOpen& c) const {
    state.session.list_open = c.open;
    state.session.close_list = state.session.close_list && c.open;
  }
  void operator()(const CloseList&) const { state.session.close_list = true; }
  void operator()(const SetSheet& c) const { state.view.sheet = c.sheet; }
  void operator()(const MeasureSheet& c) const {
    state.session.closed_sheet_height = c.closed_height;
  }
  void operator()(const MeasureNotice& c) const { state.session.notice_height = c.height; }
  void operator()(const CopyLink&) const {
    Result<std::string> link = encode_link(last_good(state));
    if (link) {
      emit(state, CopyAddress{std::move(link).value()});
    } else {
      show(state, {Notice::Kind::problem, sentence(link.error()) + "."});
    }
  }
  void operator()(const TypeValue& c) const {
    state.session.wanted_field = c.control;
    emit(state, FocusField{c.control});
  }
  void operator()(const OpenDialog& c) const { emit(state, ShowDialog{c.dialog}); }
  void operator()(const OpenPage&) const { emit(state, ShowPage{}); }
  void operator()(const LayOutAgain&) const { emit(state, NextFrame{}); }
  void operator()(const ShowNotice& c) const { show(state, c.notice); }
  void operator()(const EndNotice&) const { end_notice(state); }

  void operator()(const SetCanvas& c) const {
    set_canvas(state, c.css_width, c.css_height, c.css_ratio);
  }
  void operator()(const SetPreferences& c) const {
    Screen& screen = state.session.screen;
    screen.dark = c.dark;
    screen.reduced_motion = c.reduced_motion;
    screen.finger = c.finger;
  }
  void operator()(const SetTouch& c) const {
    state.session.screen.touch = c.on;
    state.session.screen.asking = c.asking;
    if (c.asking) state.view.explained.reset();  // the pointer asks now
  }
  void operator()(const CoverScreen& c) const { cover_screen(state, c.left, c.right, c.foot); }
  void operator()(const MakeRoom& c) const { make_room(state, c.height); }
  void operator()(const LayPicture& c) const { lay_behind(state, c.low, c.high); }
  void operator()(const TakePictureAway&) const { take_picture_away(state); }
  void operator()(const SetMeasuring& c) const {
    state.view.measuring = c.on;
    emit(state, SummaryChanged{});
  }
  void operator()(const KeepMotion& c) const { state.view.motion = c.on; }
  void operator()(const KeepComparison& c) const {
    const bool drawn = draws(state.view.tool);
    if (c.method != settings(state).method && !state.work.second_method && !drawn)
      state.work.second_method = c.method;
  }
  void operator()(const ForgetSteps&) const {
    state.work.history.clear();
    if (state.view.walkthrough.script) state.view.walkthrough.script->depth = 0;
  }
  void operator()(const AddStep& c) const {
    state.work.history.add(c.redo, c.step);
    if (c.redo || !is_other_object(c.step.edit)) return;
    // The last step that opened something tells whether a lesson is open, and how far undo must go
    // to leave it.
    Walkthrough& walk = state.view.walkthrough;
    walk.of_lesson = walk.trace && (walk.script || c.step.edit == Edit::lesson_opened);
    if (walk.script) walk.script->depth = state.work.history.depth();
  }
};

template <class... Kinds>
bool is_one_of(Command& command) {
  return (std::holds_alternative<Kinds>(command.kind()) || ...);
}

// Whether a command may take places from the robots on the screen: they must be those of the
// present shape.
bool builds_on_robots(Command& command) {
  return is_one_of<SetMethod, PlaceYourself, AddRobot, PutRobot, NameRobot, RemoveRobot>(command);
}

}  // namespace

bool apply(AppState& state, Commands& commands) {
  if (commands.empty()) return false;
  for (Command& command : commands) {
    if (builds_on_robots(command)) place_now(state);
    std::visit(Applier{state}, command.kind());
  }
  commands.clear();
  conclude(state);
  return true;
}

}  // namespace evenlift::view
