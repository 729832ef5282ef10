#include "edits/search.h"

#include <string>
#include <utility>

#include "edits/outlook.h"
#include "evenlift/formats.h"
#include "evenlift/settings.h"
#include "state/browser.h"
#include "state/notice.h"
#include "state/robots_text.h"

namespace evenlift::view {
namespace {

// Ends a search that found no robots at all. Returns false if there were some before.
bool find_none(Placement& placement) {
  if (!placement.teams.empty()) return false;
  placement.search_ended = true;
  return true;
}

// The balanced placement on the screen: the first, the second, or none.
std::optional<Placement>* balanced(AppState& state) {
  for (std::optional<Placement>* placement : {&state.placement, &state.second})
    if (*placement && (*placement)->settings.method == Method::balanced) return placement;
  return nullptr;
}

// As read_setting() takes it; nothing of a setting that has no text.
std::string line(Setting setting, const Document& document) {
  const std::string text = text_of(setting, document);
  return text.empty() ? text : std::string(name(setting)) + '=' + text + '\n';
}

// What robots and their loads depend on, for the object that is placed; the goal is the one in force.
std::string settings_text(const AppState& state, Settings settings) {
  settings.goal = goal_of(settings);
  const Document document{{}, state.placed.centre_of_mass, std::move(settings)};
  std::string text;
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::stands || row.changes == Changes::loads)
      text += line(row.setting, document);
  return text;
}

bool take_plan(AppState& state, std::string_view text) {
  state.spare = read_plan(text);
  if (!state.spare) return false;
  state.search.counting = false;
  browser::summary_changed();
  return true;
}

}  // namespace

void drop_search(AppState& state) {
  Search& search = state.search;
  if (search.under_way || search.counting) browser::end_search();
  search = {search.number, true};
}

void begin_search(AppState& state) {
  if (!state.search.due || state.edit_open) return;
  state.search.due = false;
  const std::optional<Placement>* shown = balanced(state);
  if (state.refusal || !shown || (*shown)->search_ended) return;
  const Placement& start = **shown;
  state.search = {state.search.number + 1, false, true};
  browser::begin_search(state.search.number, write_thesis(state.placed),
                        settings_text(state, start.settings),
                        robots_text(lifting_points(start.teams)));
}

void begin_count(AppState& state) {
  Search& search = state.search;
  const bool moving = state.edit_open || search.under_way;
  if (!state.placement || state.refusal || moving || search.counting || state.spare) return;
  const Settings& now = state.placement->settings;
  const bool settled = now.method == Method::balanced && state.placement->search_ended;
  if (!settled || !shown(state).capacity) return;
  search = {search.number + 1, false, false, true};
  browser::begin_search(search.number, write_thesis(state.placed),
                        settings_text(state, now) + line(Setting::capacity, state.document), {});
}

void drop_count(AppState& state) {
  if (state.search.counting) browser::end_search();
  state.search.counting = false;
  state.spare.reset();
}

bool take_robots(AppState& state, std::uint64_t number, std::string_view robots, bool ended) {
  if (state.search.counting && number == state.search.number) return take_plan(state, robots);
  std::optional<Placement>* shown = balanced(state);
  if (!state.search.under_way || number != state.search.number || !shown) return false;
  Placement& placement = **shown;
  if (ended && robots.empty()) {
    if (!find_none(placement)) return false;
  } else {
    const auto found = read_robots(robots, placement.settings.robots, placement.polygon);
    if (!found) return false;
    if (robots_text(lifting_points(placement.teams)) != robots) {
      state.explanation.reset();
      ++state.revision;
      if (shown == &state.placement) forget_failures(state);
    }
    *shown = with_robots(std::move(placement), *found, ended);
  }
  state.search.under_way = !ended;
  renew_outlook(state);
  renew_failures(state);
  browser::summary_changed();
  return true;
}

void stop_search(AppState& state, std::uint64_t number) {
  if (!state.search.under_way || number != state.search.number) return;
  state.search.under_way = false;
  renew_failures(state);
  show(state, {Notice::Kind::problem,
               "The search for better places stopped: a part of the page could not be loaded."});
  browser::summary_changed();
}

}  // namespace evenlift::view
