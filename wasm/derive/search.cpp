#include "derive/search.h"

#include <string>
#include <utility>

#include "derive/robots_text.h"
#include "derive/settings_text.h"
#include "evenlift/formats.h"

namespace evenlift::view {
namespace {

// Ends a search that found no robots. Returns false if there are robots.
bool find_none(Placement& placement) {
  if (!placement.teams.empty()) return false;
  placement.search_ended = true;
  return true;
}

// The balanced placement on the screen, or null.
std::optional<Placement>* balanced(Derived& facts) {
  for (std::optional<Placement>* placement : {&facts.placement, &facts.second})
    if (*placement && (*placement)->settings.method == Method::balanced) return placement;
  return nullptr;
}

// Settings and C as text, with the effective goal.
std::string settings_of(const Derived& facts, Settings settings) {
  settings.goal = goal_of(settings);
  return settings_text({{}, facts.placed.centre_of_mass, std::move(settings)});
}

Taken take_count(Derived& facts, const std::string& text) {
  facts.spare = read_plan(text);
  if (!facts.spare) return Taken::nothing;
  facts.search.counting = false;
  return Taken::count;
}

}  // namespace

void drop_search(Derived& facts, Effects& effects) {
  Search& search = facts.search;
  if (search.under_way || search.counting) effects.push_back(EndSearch{});
  search = {search.number, true};
}

void end_search(Derived& facts, Effects& effects) {
  drop_search(facts, effects);
  facts.search.due = false;
}

void begin_search(Derived& facts, Effects& effects) {
  if (!facts.search.due) return;
  facts.search.due = false;
  const std::optional<Placement>* shown = balanced(facts);
  if (facts.refusal || !shown || (*shown)->search_ended) return;
  const Placement& start = **shown;
  facts.search = {facts.search.number + 1, false, true};
  effects.push_back(BeginSearch{facts.search.number, write_thesis(facts.placed),
                                settings_of(facts, start.settings),
                                robots_text(lifting_points(start.teams))});
}

void begin_count(Derived& facts, const Shown& shown, Effects& effects) {
  Search& search = facts.search;
  if (!shown.capacity || !facts.placement || facts.refusal || facts.spare) return;
  if (search.under_way || search.counting) return;
  const Settings& now = facts.placement->settings;
  if (now.method != Method::balanced || !facts.placement->search_ended) return;
  search = {search.number + 1, false, false, true};
  const Document conditions{{}, {}, {}, shown};
  std::string settings = settings_of(facts, now);
  for (const SettingRow& row : all_settings())
    if (row.changes == Changes::shown && row.plans)
      settings += setting_line(row.setting, conditions);
  effects.push_back(BeginSearch{search.number, write_thesis(facts.placed), settings, {}});
}

void drop_count(Derived& facts, Effects& effects) {
  if (facts.search.counting) effects.push_back(EndSearch{});
  facts.search.counting = false;
  facts.spare.reset();
}

Taken take(Derived& facts, const Given::Found& found) {
  Search& search = facts.search;
  if (found.number != search.number) return Taken::nothing;
  if (search.counting && found.robots) return take_count(facts, *found.robots);
  std::optional<Placement>* shown = balanced(facts);
  if (!search.under_way || !shown) return Taken::nothing;
  if (!found.robots) {
    search.under_way = false;
    return Taken::same_robots;
  }
  Placement& placement = **shown;
  Taken taken = Taken::same_robots;
  if (found.ended && found.robots->empty()) {
    if (!find_none(placement)) return Taken::nothing;
  } else {
    const auto robots = read_robots(*found.robots, placement.settings.robots, placement.polygon());
    if (!robots) return Taken::nothing;
    if (robots_text(lifting_points(placement.teams)) != *found.robots) taken = Taken::other_robots;
    const bool cut_short = placement.cut_short || found.cut_short;  // in the start, or since
    *shown = with_robots(std::move(placement), *robots, found.ended, cut_short);
  }
  search.under_way = !found.ended;
  return taken;
}

}  // namespace evenlift::view
