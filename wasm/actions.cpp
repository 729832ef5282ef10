#include "actions.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace evenlift::view {
namespace {

bool always(const AppState&) { return true; }
bool editing(const AppState& s) { return !s.screen.embed; }

bool has_teams_number(const AppState& s) { return editing(s) && s.placement.has_value(); }

// From "max" one step down is the number of teams that there are.
std::uint32_t teams_now(const AppState& s) {
  return settings(s).teams.value_or(
      static_cast<std::uint32_t>(s.placement ? s.placement->teams.size() : 3));
}

void set_teams(const AppState& s, Commands& out, std::int64_t teams) {
  Settings changed = settings(s);
  changed.teams = static_cast<std::uint32_t>(std::clamp<std::int64_t>(teams, 1, max_teams));
  out.push_back(SetSettings{changed});
}

void next_method(const AppState& s, Commands& out) {
  Settings changed = settings(s);
  const auto at = std::find(std::begin(all_metrics), std::end(all_metrics), changed.metric);
  changed.metric = std::next(at) == std::end(all_metrics) ? all_metrics[0] : *std::next(at);
  out.push_back(SetSettings{changed});
}

void change_ratio(const AppState& s, Commands& out, double steps) {
  Settings changed = settings(s);
  changed.min_ratio = std::clamp(std::round(changed.min_ratio * 100 + steps) / 100, 0.0, 1.0);
  out.push_back(SetSettings{changed});
}

template <bool Overlays::*overlay>
void toggle(const AppState& s, Commands& out) {
  Settings changed = settings(s);
  changed.overlays.*overlay = !(changed.overlays.*overlay);
  out.push_back(SetSettings{changed});
}

// Escape takes away the topmost thing that is in the way.
bool anything_open(const AppState& s) {
  return s.list_open || s.help_open || s.selected || !s.notice.text.empty();
}
void dismiss(const AppState& s, Commands& out) {
  if (s.list_open)
    out.push_back(CloseList{});
  else if (s.help_open)
    out.push_back(SetHelpOpen{false});
  else if (!s.notice.text.empty())
    out.push_back(ShowNotice{});
  else
    out.push_back(SelectVertex{});
}

template <browser::Dialog dialog>
void show(const AppState&, Commands& out) {
  out.push_back(OpenDialog{dialog});
}

const std::vector<Action> table = {
    {ActionId::samples,
     Icon::shapes,
     "Samples",
     "G",
     {{"g"}},
     editing,
     show<browser::Dialog::samples>},
    {ActionId::open, Icon::folder, "Open", "O", {{"o"}}, editing, show<browser::Dialog::open>},
    {ActionId::save, Icon::save, "Save", "S", {{"s"}}, editing, show<browser::Dialog::save>},
    {ActionId::table,
     Icon::table,
     "Coordinates",
     "E",
     {{"e"}},
     editing,
     show<browser::Dialog::table>},
    {ActionId::undo,
     Icon::undo,
     "Undo",
     "Ctrl+Z",
     {{"z", true}},
     [](const AppState& s) { return s.history.can_undo(); },
     [](const AppState&, Commands& out) { out.push_back(Undo{}); }},
    {ActionId::redo,
     Icon::redo,
     "Redo",
     "Ctrl+Shift+Z",
     {{"z", true, true}, {"y", true}},
     [](const AppState& s) { return s.history.can_redo(); },
     [](const AppState&, Commands& out) { out.push_back(Redo{}); }},
    {ActionId::copy_link,
     Icon::link,
     "Copy link",
     "Ctrl+C",
     {{"c", true}},
     always,
     [](const AppState&, Commands& out) { out.push_back(CopyLink{}); }},
    {ActionId::remove_vertex,
     Icon::close,
     "Remove the selected vertex",
     "Delete",
     {{"Delete"}, {"Backspace"}},
     [](const AppState& s) { return s.selected.has_value(); },
     [](const AppState& s, Commands& out) { out.push_back(RemoveVertex{*s.selected}); }},
    {ActionId::more_teams,
     Icon::plus,
     "One team more",
     "T",
     {{"t"}},
     has_teams_number,
     [](const AppState& s, Commands& out) { set_teams(s, out, std::int64_t{teams_now(s)} + 1); }},
    {ActionId::fewer_teams,
     Icon::minus,
     "One team fewer",
     "Shift+T",
     {{"T"}},
     has_teams_number,
     [](const AppState& s, Commands& out) { set_teams(s, out, std::int64_t{teams_now(s)} - 1); }},
    {ActionId::next_method, Icon::none, "Next method", "M", {{"m"}}, editing, next_method},
    {ActionId::higher_ratio,
     Icon::none,
     "Raise the minimum load ratio",
     ".",
     {{"."}},
     editing,
     [](const AppState& s, Commands& out) { change_ratio(s, out, 1); }},
    {ActionId::lower_ratio,
     Icon::none,
     "Lower the minimum load ratio",
     ",",
     {{","}},
     editing,
     [](const AppState& s, Commands& out) { change_ratio(s, out, -1); }},
    {ActionId::toggle_hull,
     Icon::none,
     "Show the lifting base",
     "H",
     {{"h"}},
     always,
     toggle<&Overlays::hull>},
    {ActionId::toggle_clockwise,
     Icon::none,
     "Show free clockwise turns",
     "R",
     {{"r"}},
     always,
     toggle<&Overlays::clockwise>},
    {ActionId::toggle_counterclockwise,
     Icon::none,
     "Show free counter-clockwise turns",
     "L",
     {{"l"}},
     always,
     toggle<&Overlays::counterclockwise>},
    {ActionId::toggle_chords,
     Icon::none,
     "Show the teams' chords",
     "C",
     {{"c"}},
     always,
     toggle<&Overlays::chords>},
    {ActionId::toggle_candidates,
     Icon::none,
     "Show the candidates",
     "A",
     {{"a"}},
     always,
     toggle<&Overlays::candidates>},
    {ActionId::zoom_in,
     Icon::plus,
     "Zoom in",
     "+",
     {{"+"}, {"="}},
     always,
     [](const AppState&, Commands& out) { out.push_back(ZoomView{1.25}); }},
    {ActionId::zoom_out,
     Icon::minus,
     "Zoom out",
     "−",
     {{"-"}},
     always,
     [](const AppState&, Commands& out) { out.push_back(ZoomView{0.8}); }},
    {ActionId::fit,
     Icon::fit,
     "Show all of the object",
     "0",
     {{"0"}},
     always,
     [](const AppState&, Commands& out) { out.push_back(FitView{}); }},
    {ActionId::fold_panel,
     Icon::fold,
     "Fold the panel away",
     "P",
     {{"p"}},
     editing,
     [](const AppState& s, Commands& out) { out.push_back(SetPanelOpen{!s.panel_open}); }},
    {ActionId::help,
     Icon::help,
     "Keys",
     "?",
     {{"?"}},
     always,
     [](const AppState& s, Commands& out) { out.push_back(SetHelpOpen{!s.help_open}); }},
    {ActionId::dismiss,
     Icon::close,
     "Close, or select nothing",
     "Esc",
     {{"Escape"}},
     anything_open,
     dismiss},
};

bool same(const Key& wanted, const Key& pressed) {
  if (wanted.name.empty() || wanted.command != pressed.command) return false;
  if (wanted.command) {
    // With Shift, the letter is a capital; with Caps Lock, it may be one without Shift.
    return wanted.shift == pressed.shift && wanted.name.size() == pressed.name.size() &&
           (wanted.name[0] | 0x20) == (pressed.name[0] | 0x20);
  }
  return wanted.name == pressed.name;
}

}  // namespace

const std::vector<Action>& actions() { return table; }

const Action& action(ActionId id) {
  return *std::find_if(table.begin(), table.end(), [&](const Action& a) { return a.id == id; });
}

const Action* action_for(const AppState& state, const Key& key) {
  for (const Action& candidate : table) {
    const bool matches = std::any_of(std::begin(candidate.keys), std::end(candidate.keys),
                                     [&](const Key& wanted) { return same(wanted, key); });
    if (matches && candidate.enabled(state)) return &candidate;
  }
  return nullptr;
}

}  // namespace evenlift::view
