#include "walkthrough/script.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "evenlift/wording.h"

namespace evenlift::view {

void find_stops(Walkthrough& walk) {
  if (!walk.script) return;
  Script& script = *walk.script;
  script.stops.clear();
  for (const LessonStep& step : script.lesson.steps) {
    if (const auto found = find_step(*walk.trace, step.address))
      script.stops.push_back({*found, step.words});
  }
  if (script.stops.empty()) return walk.script.reset();
  script.position = std::min(script.position, script.stops.size() - 1);
}

void settle_position(Walkthrough& walk) {
  if (!walk.script) return;
  Script& script = *walk.script;
  if (script.stops[script.position].step == walk.at) return;
  const auto exact = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step == walk.at; });
  const auto later = std::find_if(script.stops.begin(), script.stops.end(),
                                  [&](const Stop& s) { return s.step > walk.at; });
  const auto at = exact != script.stops.end() ? exact : later;
  const auto index = at - script.stops.begin();
  script.position = static_cast<std::size_t>(
      exact != script.stops.end() ? index : std::max<std::ptrdiff_t>(index - 1, 0));
}

void begin_script(AppState& state, Script script) {
  Walkthrough& walk = state.view.walkthrough;
  walk.predict = script.lesson.predict;
  walk.guesses = {};
  walk.all_steps = false;
  walk.aside.reset();
  walk.script = std::move(script);
  walk.script->depth = state.work.history.depth();
  find_stops(walk);
  settle_position(walk);
}

bool script_is_true(const AppState& state) {
  const std::optional<Script>& script = state.view.walkthrough.script;
  const Document& document = state.work.document();
  return script && script->of.vertices == document.vertices && script->of.holes == document.holes &&
         script->of.centre_of_mass == document.centre_of_mass;
}

std::string words_of_stop(const AppState& state) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.script || walk.ask) return {};
  const Document& of = walk.script->of;
  if (!script_is_true(state) || of.settings != settings(state) ||
      seen_as(of.shown, shown(state)) != shown(state))
    return say(
        "You changed the shape or a setting, so the lesson's words no longer apply. Undo brings them back.");
  const Stop& stop = walk.script->stops[walk.script->position];
  return stop.step == walk.at ? stop.words : std::string();
}

}  // namespace evenlift::view
