#include "actions/actions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "actions/pointer.h"
#include "evenlift/wording.h"
#include "state/method.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "tools/picture_marks.h"
#include "tools/transform.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {

std::vector<const Action*> key_list(bool embed) {
  std::vector<const Action*> list;
  for (const Group group :
       {Group::files, Group::editing, Group::teams, Group::view, Group::lesson, Group::help})
    for (const Action& a : actions()) {
      const bool left_out = embed && (a.group < Group::view || a.enabled == when::editing);
      if (a.group == group && *a.shown && !left_out) list.push_back(&a);
    }
  return list;
}

namespace {

// With "max" teams, one step down begins at the number placed.
std::uint32_t teams_now(const AppState& s) { return settings(s).teams.value_or(placed_teams(s)); }

template <int by>
void change_number(const AppState& s, Commands& out) {
  Settings changed = settings(s);
  if (changed.method == Method::given)
    return out.push_back(by > 0 ? Command(AddRobot{}) : Command(RemoveRobot{}));
  const auto within = [](std::int64_t number, std::uint32_t low, std::uint32_t high) {
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(number, low, high));
  };
  if (changed.method == Method::balanced)
    changed.robots = within(std::int64_t{changed.robots} + by, fewest_robots(changed), most_robots);
  else
    changed.teams = within(std::int64_t{teams_now(s)} + by, 1, max_teams);
  out.push_back(SetSettings{changed});
}

void next_method(const AppState& s, Commands& out) {
  const auto* at =
      std::find(std::begin(named_methods), std::end(named_methods), settings(s).method);
  const auto next = static_cast<std::size_t>(at - std::begin(named_methods)) + 1;
  out.push_back(SetMethod{named_methods[next % std::size(named_methods)]});
}

void change_ratio(const AppState& s, Commands& out, double steps) {
  Settings changed = settings(s);
  changed.min_ratio = std::clamp(std::round(changed.min_ratio * 100 + steps) / 100, 0.0, 1.0);
  out.push_back(SetSettings{changed});
}

template <bool Overlays::*overlay>
void toggle(const AppState& s, Commands& out) {
  Shown changed = shown(s);
  changed.overlays.*overlay = !(changed.overlays.*overlay);
  out.push_back(SetShown{changed});
}

template <class Asked>
void ask(const AppState&, Commands& out) {
  out.push_back(Asked{});
}

template <Dialog dialog>
void show(const AppState&, Commands& out) {
  out.push_back(OpenDialog{dialog});
}

template <Tool tool>
void take(const AppState& s, Commands& out) {
  out.push_back(SetTool{s.view.tool == tool ? Tool::parts : tool});
}

// The first key press only shows the cursor.
void place(const AppState& s, Commands& out) {
  if (when::has_no_cursor(s))
    move_cursor(s, out, 0, 0, false);
  else if (closes(s, s.view.camera.to_screen(*s.view.drawing.cursor)))
    out.push_back(FinishDrawing{});
  else
    out.push_back(AddPoint{*s.view.drawing.cursor});
}
void finish(const AppState& s, Commands& out) {
  if (when::keys_place(s) || when::has_no_cursor(s))
    place(s, out);
  else
    out.push_back(FinishDrawing{});
}

void begin_or_end_walkthrough(const AppState& s, Commands& out) {
  if (when::in_walkthrough(s))
    out.push_back(CloseWalkthrough{});
  else
    out.push_back(OpenWalkthrough{});
}
template <int by>
void move_step(const AppState&, Commands& out) {
  out.push_back(MoveSteps{by});
}
template <int by>
void move_chapter(const AppState&, Commands& out) {
  out.push_back(MoveChapters{by});
}

void undo(const AppState& s, Commands& out) {
  if (when::drawing(s) && !can_go_on_drawing(s))
    out.push_back(TakePointBack{});
  else
    out.push_back(Undo{});
}
void redo(const AppState& s, Commands& out) {
  if (when::drawing(s))
    out.push_back(PutPointBack{});
  else
    out.push_back(Redo{});
}

template <int by>
void select_vertex(const AppState& s, Commands& out) {
  const std::size_t n = count_handles(s.work.document());
  const std::size_t now = s.view.selected.value_or(by > 0 ? n - 1 : 0);
  out.push_back(SelectVertex{by > 0 ? (now + 1) % n : (now + n - 1) % n});
}

void insert_vertex(const AppState& s, Commands& out) {
  const Vec2 a = place_of(s.work.document(), *s.view.selected),
             b = after(s.work.document(), *s.view.selected);
  out.push_back(InsertVertex{*s.view.selected, a + (b - a) / 2});
}

template <int x, int y>
void move_cursor_finely(const AppState& s, Commands& out) {
  move_cursor(s, out, x, y, true);
}
template <int x, int y>
void nudge_by(const AppState& s, Commands& out) {
  nudge(s, out, x, y);
}

template <int steps>
void turn(const AppState& s, Commands& out) {
  out.push_back(turned_polygon(s, steps));
}
template <int tenths>
void scale(const AppState& s, Commands& out) {
  out.push_back(scaled_polygon(s, tenths / 10.0));
}

template <bool Snap::*which>
void snap(const AppState& s, Commands& out) {
  Snap changed = s.view.snap;
  changed.*which = !(changed.*which);
  out.push_back(SetSnap{changed});
}

// The next method to compare with, or none after the last.
void next_second_method(const AppState& s, Commands& out) {
  const Method own = settings(s).method;
  const auto from =
      s.work.second_method
          ? std::find(std::begin(all_methods), std::end(all_methods), *s.work.second_method) + 1
          : std::begin(all_methods);
  const auto next = std::find_if(from, std::end(all_methods), [&](Method m) { return m != own; });
  out.push_back(
      Compare{next == std::end(all_methods) ? std::nullopt : std::optional<Method>(*next)});
}

void take_all_teams(const AppState& s, Commands& out) {
  Settings changed = settings(s);
  changed.teams =
      changed.teams ? std::nullopt : std::optional<std::uint32_t>(std::max(1u, teams_now(s)));
  out.push_back(SetSettings{changed});
}

// Opens the panel, then the field of a value. The names are those of the panels' controls.
constexpr char typed_ratio[] = "min ratio", typed_weight[] = "weight", typed_seed[] = "seed",
               typed_centre[] = "com", typed_capacity[] = "capacity",
               typed_uncertainty[] = "com radius", typed_radius[] = "robot radius";
template <const char* control>
void type_value(const AppState& s, Commands& out) {
  if (!s.view.panel_open) out.push_back(SetPanelOpen{true});
  if (s.view.sheet == Sheet::closed) out.push_back(SetSheet{Sheet::half});
  out.push_back(TypeValue{control});
}
// The next edge's fields are in the tool's bar or on the closed sheet. A pressed digit begins
// the number.
void type_edge(const AppState& s, Commands& out) {
  if (s.view.sheet != Sheet::closed) out.push_back(SetSheet{Sheet::closed});
  out.push_back(TypeValue{"edge length"});
}

void explain_next(const AppState& s, Commands& out) {
  const std::optional<PictureMark> now = explained_mark(s);
  for (const PictureMark mark : marks_in_picture(s))
    if (!now || mark > *now) return out.push_back(ExplainMark{mark});
  out.push_back(ExplainMark{});
}

// The robot with the open card, or the next one; none after the last.
void fail_next(const AppState& s, Commands& out) {
  const std::optional<std::size_t> asked =
      s.derived().explanation ? s.derived().explanation->robot : std::nullopt;
  if (asked && !(s.derived().failure && s.derived().failure->robot == *asked))
    return out.push_back(Fail{asked});
  const std::size_t next = s.derived().failure ? s.derived().failure->robot + 1 : 0;
  const bool is_one = next < count_robots(s.derived().placement->teams);
  out.push_back(Fail{is_one ? std::optional<std::size_t>(next) : std::nullopt});
}

void close_card(Commands& out) {
  out.push_back(Explain{});
  out.push_back(Fail{});
}
void dismiss(const AppState& s, Commands& out) {
  if (s.session.list_open)
    out.push_back(CloseList{});
  else if (explained_mark(s))
    out.push_back(ExplainMark{});
  else if (s.derived().explanation || failing(s))
    close_card(out);
  else if (when::drawing(s) && !s.view.drawing.points.empty())
    out.push_back(TakePointBack{});  // any notice concerns that point
  else if (!s.session.notice.text.empty())
    out.push_back(ShowNotice{});
  else if (!s.view.walkthrough.why.empty() && when::in_walkthrough(s))
    out.push_back(AskWhy{});
  else if (s.view.presenting)
    out.push_back(SetPresenting{false});
  else if (when::in_walkthrough(s))
    out.push_back(CloseWalkthrough{});
  else if (s.view.tool != Tool::parts)
    out.push_back(SetTool{Tool::parts});
  else
    out.push_back(SelectVertex{});
}

// clang-format off
const std::vector<Action> table = {
    {ActionId::samples, Group::files, Icon::shapes, "Samples", "G", {{"g"}}, when::editing, show<Dialog::samples>},
    {ActionId::draw, Group::editing, Icon::draw, "Draw", "D", {{"d"}}, when::editing, take<Tool::draw>},
    {ActionId::lessons, Group::lesson, Icon::board, "Lessons", "Shift+B", {{"B"}}, when::editing, show<Dialog::lessons>},
    {ActionId::walkthrough, Group::lesson, Icon::board, "Step by step, on this object", "B", {{"b"}}, when::can_teach, begin_or_end_walkthrough},
    {ActionId::step_on, Group::lesson, Icon::step_on, "Next step", "Right", {{"ArrowRight"}}, when::can_go_on, move_step<1>},
    {ActionId::step_back, Group::lesson, Icon::step_back, "Previous step", "Left", {{"ArrowLeft"}}, when::can_go_back, move_step<-1>},
    {ActionId::next_chapter, Group::lesson, Icon::chapter_on, "Next chapter", "Page down", {{"PageDown"}}, when::in_walkthrough, move_chapter<1>},
    {ActionId::previous_chapter, Group::lesson, Icon::chapter_back, "Previous chapter", "Page up", {{"PageUp"}}, when::in_walkthrough, move_chapter<-1>},
    {ActionId::first_step, Group::lesson, Icon::first, "First step", "Home", {{"Home"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(GoToStep{step_of(s, 0)}); }},
    {ActionId::last_step, Group::lesson, Icon::last, "Last step", "End", {{"End"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(GoToStep{step_of(s, timeline(s).count - 1)}); }},
    {ActionId::play, Group::lesson, Icon::play, "Play or pause", "Space", {{" "}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(SetPlaying{!s.view.walkthrough.playing}); }},
    {ActionId::faster, Group::lesson, Icon::none, "Play faster or slower", "Up, down", {{"ArrowUp"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(SetSpeed{s.view.walkthrough.speed * 2}); }},
    {ActionId::slower, Group::lesson, Icon::none, "Play slower", "", {{"ArrowDown"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(SetSpeed{s.view.walkthrough.speed / 2}); }},
    {ActionId::predict, Group::lesson, Icon::none, "Predict before each choice", "Q", {{"q"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(SetPredict{!s.view.walkthrough.predict}); }},
    {ActionId::all_steps, Group::lesson, Icon::none, "All steps, or only the main ones", "U", {{"u"}}, when::in_walkthrough,
     [](const AppState& s, Commands& out) { out.push_back(ShowAllSteps{s.view.walkthrough.script || !s.view.walkthrough.all_steps}); }},
    {ActionId::present, Group::lesson, Icon::present, "Presentation mode, full screen", "Shift+P", {{"P"}}, when::editing,
     [](const AppState& s, Commands& out) { out.push_back(SetPresenting{!s.view.presenting}); }},
    {ActionId::open, Group::files, Icon::folder, "Open", "O", {{"o"}}, when::editing, show<Dialog::open>},
    {ActionId::save, Group::files, Icon::save, "Save", "S", {{"s"}}, when::editing, show<Dialog::save>},
    {ActionId::undo, Group::editing, Icon::undo, "Undo", "Ctrl+Z", {{"z", true}}, when::can_undo, undo},
    {ActionId::redo, Group::editing, Icon::redo, "Redo", "Ctrl+Shift+Z", {{"z", true, true}, {"y", true}}, when::can_redo, redo},
    {ActionId::copy_link, Group::files, Icon::link, "Copy link", "Ctrl+C", {{"c", true}}, when::always, ask<CopyLink>},
    {ActionId::table, Group::editing, Icon::table, "Coordinates", "E", {{"e"}}, when::editing, show<Dialog::table>},
    {ActionId::transform, Group::editing, Icon::transform, "Move, turn or scale the shape", "W", {{"w"}}, when::editing, take<Tool::transform>},
    {ActionId::mark, Group::editing, Icon::draw, "Mark no-go parts", "Shift+N", {{"N"}}, when::editing, take<Tool::mark>},
    {ActionId::add_robots, Group::teams, Icon::robot, "Add robots by hand", "Shift+D", {{"D"}}, when::has_teams_number, take<Tool::robot>},
    {ActionId::finish, Group::editing, Icon::check, "Close the drawn shape", "Enter", {{"Enter"}}, when::can_finish, finish},
    {ActionId::place, Group::editing, Icon::none, "Place a vertex at the cursor", "Space", {{" "}}, when::can_place, place},
    {ActionId::take_back, Group::editing, Icon::none, "Remove the last vertex", "Backspace", {{"Backspace"}}, when::can_take_back, ask<TakePointBack>},
    {ActionId::type_edge, Group::editing, Icon::none, "Type the length of the next edge", "Digits",
     {{"0"}, {"1"}, {"2"}, {"3"}, {"4"}, {"5"}, {"6"}, {"7"}, {"8"}, {"9"}, {"."}, {","}}, when::can_take_back, type_edge},
    {ActionId::next_vertex, Group::editing, Icon::none, "Select the next vertex or weight", "V", {{"v"}}, when::on_parts, select_vertex<1>},
    {ActionId::previous_vertex, Group::editing, Icon::none, "Select the previous vertex or weight", "Shift+V", {{"V"}}, when::on_parts, select_vertex<-1>},
    {ActionId::insert_vertex, Group::editing, Icon::none, "Add a vertex after the selected one", "I", {{"i"}}, when::on_ring, insert_vertex},
    {ActionId::remove_vertex, Group::editing, Icon::close, "Remove the selected vertex or weight", "Delete", {{"Delete"}, {"Backspace"}}, when::on_vertex,
     [](const AppState& s, Commands& out) { out.push_back(RemoveVertex{*s.view.selected}); }},
    {ActionId::left_finely, Group::editing, Icon::none, "Move the drawing cursor by a pixel", "Shift+arrows", {{"ArrowLeft", false, true}}, when::drawing, move_cursor_finely<-1, 0>},
    {ActionId::right_finely, Group::editing, Icon::none, "Move the cursor to the right by a pixel", "", {{"ArrowRight", false, true}}, when::drawing, move_cursor_finely<1, 0>},
    {ActionId::up_finely, Group::editing, Icon::none, "Move the cursor up by a pixel", "", {{"ArrowUp", false, true}}, when::drawing, move_cursor_finely<0, 1>},
    {ActionId::down_finely, Group::editing, Icon::none, "Move the cursor down by a pixel", "", {{"ArrowDown", false, true}}, when::drawing, move_cursor_finely<0, -1>},
    {ActionId::left, Group::editing, Icon::none, "Move the selected vertex or weight, the robot whose card is open, the shape, or the drawing cursor", "Arrows", {{"ArrowLeft"}}, when::can_nudge, nudge_by<-1, 0>},
    {ActionId::right, Group::editing, Icon::none, "Move to the right", "", {{"ArrowRight"}}, when::can_nudge, nudge_by<1, 0>},
    {ActionId::up, Group::editing, Icon::none, "Move up", "", {{"ArrowUp"}}, when::can_nudge, nudge_by<0, 1>},
    {ActionId::down, Group::editing, Icon::none, "Move down", "", {{"ArrowDown"}}, when::can_nudge, nudge_by<0, -1>},
    {ActionId::turn_left, Group::editing, Icon::none, "Turn the shape by 15°", "[ ]", {{"["}}, when::transforming, turn<1>},
    {ActionId::turn_right, Group::editing, Icon::none, "Turn the shape clockwise", "", {{"]"}}, when::transforming, turn<-1>},
    {ActionId::larger, Group::editing, Icon::none, "Scale the shape", "{ }", {{"}"}}, when::transforming, scale<11>},
    {ActionId::smaller, Group::editing, Icon::none, "Make the shape smaller", "", {{"{"}}, when::transforming, scale<9>},
    {ActionId::snap_grid, Group::editing, Icon::none, "Snap to the grid", "N", {{"n"}}, when::editing, snap<&Snap::grid>},
    {ActionId::snap_axis, Group::editing, Icon::none, "Snap to the axis", "X", {{"x"}}, when::editing, snap<&Snap::axis>},
    {ActionId::place_yourself, Group::teams, Icon::none, "Place four robots yourself", "Shift+X", {{"X"}}, when::has_teams_number, ask<PlaceYourself>},
    {ActionId::remove_robot, Group::teams, Icon::none, "Remove the robot whose card is open", "Delete", {{"Delete"}, {"Backspace"}}, when::on_own_robot,
     [](const AppState& s, Commands& out) { out.push_back(RemoveRobot{s.derived().placement->support_of(*s.derived().explanation->robot)}); }},
    {ActionId::even_out, Group::teams, Icon::none, "Even out the robots placed by hand", "Shift+Q", {{"Q"}}, when::can_even_out, ask<EvenOut>},
    {ActionId::weigh, Group::teams, Icon::none, "Weigh it: type the readings of scales, load cells or robots", "Shift+I", {{"I"}}, when::can_weigh, show<Dialog::weigh>},
    {ActionId::take_over, Group::teams, Icon::none, "Keep the weight and C that were weighed, without the readings", "", {}, when::is_weighed, ask<TakeOver>},
    {ActionId::more_teams, Group::teams, Icon::plus, "One more team or robot", "T", {{"t"}}, when::has_teams_number, change_number<1>},
    {ActionId::fewer_teams, Group::teams, Icon::minus, "One fewer team or balanced robot", "Shift+T", {{"T"}}, when::has_teams_number, change_number<-1>},
    {ActionId::next_method, Group::teams, Icon::none, "Next method", "M", {{"m"}}, when::can_change_method, next_method},
    {ActionId::balanced, Group::teams, Icon::none, "Equal loads: balanced robots, which can all carry the same load", "Z", {{"z"}}, when::can_change_method,
     [](const AppState&, Commands& out) { out.push_back(SetMethod{Method::balanced}); }},
    {ActionId::compare, Group::teams, Icon::compare, "Compare with another method", "K", {{"k"}}, when::can_change_method, next_second_method},
    {ActionId::experiment, Group::teams, Icon::charts, "Compare all methods in charts", "Shift+K", {{"K"}}, when::can_change_method,
     show<Dialog::experiment>},
    {ActionId::higher_ratio, Group::teams, Icon::none, "Raise the minimum load ratio", ".", {{"."}}, when::editing,
     [](const AppState& s, Commands& out) { change_ratio(s, out, 1); }},
    {ActionId::lower_ratio, Group::teams, Icon::none, "Lower the minimum load ratio", ",", {{","}}, when::editing,
     [](const AppState& s, Commands& out) { change_ratio(s, out, -1); }},
    {ActionId::all_teams, Group::teams, Icon::none, "A team on every candidate, or the former number", "*", {{"*"}}, when::by_candidates, take_all_teams},
    {ActionId::fail, Group::teams, Icon::none, "Let the next robot fail; after the last one, none", "Shift+F", {{"F"}}, when::can_fail, fail_next},
    {ActionId::type_ratio, Group::teams, Icon::none, "Type the minimum load ratio", "Shift+R", {{"R"}}, when::editing, type_value<typed_ratio>},
    {ActionId::type_weight, Group::teams, Icon::none, "Type the weight", "Y", {{"y"}}, when::editing, type_value<typed_weight>},
    {ActionId::type_robot, Group::teams, Icon::none, "Type the radius of a robot", "Shift+H", {{"H"}}, when::editing, type_value<typed_radius>},
    {ActionId::type_capacity, Group::teams, Icon::none, "Type the capacity of a robot", "Shift+Y", {{"Y"}}, when::editing, type_value<typed_capacity>},
    {ActionId::type_uncertainty, Group::teams, Icon::none, "Type the C uncertainty", "Shift+E", {{"E"}}, when::editing, type_value<typed_uncertainty>},
    {ActionId::type_seed, Group::teams, Icon::none, "Type the seed of random teams", "Shift+U", {{"U"}}, when::is_random, type_value<typed_seed>},
    {ActionId::type_centre, Group::teams, Icon::none, "Type the centre of mass", "J", {{"j"}}, when::editing, type_value<typed_centre>},
    {ActionId::free_centre, Group::teams, Icon::none, "Centre of mass back to the centroid", "Shift+J", {{"J"}}, when::has_own_centre, ask<ReleaseCentre>},
    {ActionId::toggle_hull, Group::view, Icon::none, "Show the lifting base", "H", {{"h"}}, when::always, toggle<&Overlays::lifting_base>},
    {ActionId::toggle_clockwise, Group::view, Icon::none, "Show free clockwise turns", "R", {{"r"}}, when::always, toggle<&Overlays::clockwise>},
    {ActionId::toggle_counterclockwise, Group::view, Icon::none, "Show free counter-clockwise turns", "L", {{"l"}}, when::always,
     toggle<&Overlays::counterclockwise>},
    {ActionId::toggle_chords, Group::view, Icon::none, "Show the teams' chords", "C", {{"c"}}, when::always, toggle<&Overlays::chords>},
    {ActionId::toggle_candidates, Group::view, Icon::none, "Show the candidates", "A", {{"a"}}, when::always, toggle<&Overlays::candidates>},
    {ActionId::toggle_tipping, Group::view, Icon::none, "Show the force that tips", "F", {{"f"}}, when::always, toggle<&Overlays::tipping>},
    {ActionId::toggle_halo, Group::view, Icon::none, "Show the tipping distance", "Shift+C", {{"C"}}, when::always, toggle<&Overlays::halo>},
    {ActionId::toggle_tilt, Group::view, Icon::none, "Show the slopes at which it tips", "Shift+S", {{"S"}}, when::has_height, toggle<&Overlays::tilt>},
    {ActionId::toggle_load, Group::view, Icon::none, "Show where the extra load may stand", "Shift+L", {{"L"}}, when::has_extra, toggle<&Overlays::load>},
    {ActionId::zoom_in, Group::view, Icon::plus, "Zoom in", "+", {{"+"}, {"="}}, when::always,
     [](const AppState&, Commands& out) { out.push_back(ZoomView{1.25}); }},
    {ActionId::zoom_out, Group::view, Icon::minus, "Zoom out", "−", {{"-"}}, when::always,
     [](const AppState&, Commands& out) { out.push_back(ZoomView{0.8}); }},
    {ActionId::fit, Group::view, Icon::fit, "Show the whole object", "0", {{"0"}}, when::always, ask<FitView>},
    {ActionId::fold_panel, Group::view, Icon::fold, "Fold the panel away", "P", {{"p"}}, when::editing,
     [](const AppState& s, Commands& out) { out.push_back(SetPanelOpen{!s.view.panel_open}); }},
    {ActionId::motion, Group::view, Icon::none, "Motion on or off", "Shift+M", {{"M"}}, when::always,
     [](const AppState& s, Commands& out) { out.push_back(SetMotion{!s.view.motion}); }},
    {ActionId::help, Group::help, Icon::help, "Keys", "?", {{"?"}}, when::always, show<Dialog::keys>},
    {ActionId::about, Group::help, Icon::about, "About evenlift", "Shift+A", {{"A"}}, when::editing, show<Dialog::about>},
    {ActionId::explain, Group::help, Icon::none, "Explain the next mark of the picture", "/", {{"/"}}, when::has_marks, explain_next},
    {ActionId::glossary, Group::help, Icon::book, "Glossary", "Shift+G", {{"G"}}, when::always, show<Dialog::glossary>},
    {ActionId::welcome, Group::help, Icon::none, "How to begin, and the tour", "Shift+W", {{"W"}}, when::editing, show<Dialog::welcome>},
    // Named in the other language, for its readers.
    {ActionId::language, Group::help, Icon::none, "Deutsch", "", {}, when::editing, show<Dialog::language>},
    {ActionId::dismiss, Group::help, Icon::close, "Close, or select nothing", "Esc", {{"Escape"}}, when::anything_open, dismiss},
};
// clang-format on

bool same(const Key& wanted, const Key& pressed) {
  if (wanted.name.empty() || wanted.command != pressed.command) return false;
  if (wanted.command) {
    // Shift makes the letter a capital, but so may Caps Lock.
    return wanted.shift == pressed.shift && wanted.name.size() == pressed.name.size() &&
           (wanted.name[0] | 0x20) == (pressed.name[0] | 0x20);
  }
  return wanted.name == pressed.name && (!wanted.shift || pressed.shift);
}

}  // namespace

const std::vector<Action>& actions() { return table; }

const Action& action(ActionId id) {
  return *std::find_if(table.begin(), table.end(), [&](const Action& a) { return a.id == id; });
}

std::string tip(const Action& action, const AppState& state) {
  std::string text = action.label;
  if (!draws(state.view.tool)) {  // while drawing, undo visibly removes a vertex
    if (action.id == ActionId::undo && state.work.history.can_undo())
      text = say("{action}: {edit}", {text, in_words(state.work.history.undoes())});
    if (action.id == ActionId::redo && state.work.history.can_redo())
      text = say("{action}: {edit}", {text, in_words(state.work.history.redoes())});
  }
  const bool has_keys = *action.shown && !state.session.screen.touch;
  return has_keys ? say("{action} ({key})", {text, action.shown}) : text;
}

const Action* action_for(const AppState& state, const Key& key) {
  // A key is not for what lies behind an open list.
  if (state.session.list_open && key.name != "Escape") return nullptr;
  for (const Action& candidate : table) {
    const bool matches = std::any_of(std::begin(candidate.keys), std::end(candidate.keys),
                                     [&](const Key& wanted) { return same(wanted, key); });
    if (matches && candidate.enabled(state)) return &candidate;
  }
  return nullptr;
}

}  // namespace evenlift::view
