#include "panels/summary.h"

#include <algorithm>

#include "evenlift/output/words.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

Verdict of_placement(const Placement& placement, const std::optional<double>& capacity) {
  const bool as_asked =
      !placement.teams.empty() && placement.teams.size() >= placement.requested_teams;
  const bool overloaded = capacity && placement.loads && placement.loads->max > *capacity;
  // A coverage below one half is no good result.
  const bool good = as_asked && placement.coverage >= 0.5 && !overloaded;
  return {good ? Mood::good : Mood::not_quite, loads_in_words(placement),
          detail_in_words(placement)};
}

Verdict of_drawing(const AppState& state) {
  const std::size_t n = state.drawing.points.size();
  const std::string press = state.screen.touch ? "Tap" : "Click";
  if (n == 0) return {Mood::drawing, "Draw a shape.", press + " where its first vertex is."};
  return {Mood::drawing, count_of(n, "vertex", "vertices") + " so far.",
          n < 3 ? "A shape needs at least three." : press + " the first one to close the shape."};
}

}  // namespace

std::string need_in_words(const AppState& state) {
  if (!state.capacity || !state.placement) return {};
  return capacity_in_words(*state.placement, *state.capacity, state.plan ? &*state.plan : nullptr);
}

Verdict verdict(const AppState& state) {
  if (state.tool == Tool::draw) return of_drawing(state);
  if (state.refusal) {
    return {Mood::refused, sentence(*state.refusal) + ".",
            state.placement ? "The last result is shown dimmed." : ""};
  }
  if (!state.placement) return {Mood::refused, "Nothing is open.", ""};
  return of_placement(*state.placement, state.capacity);
}

std::string summary(const AppState& state) {
  const Verdict v = verdict(state);
  if (walkthrough_is_open(state) && !state.refusal) return walkthrough_in_words(state);
  std::string text = v.headline;
  for (const std::string& more : {v.detail, state.refusal ? std::string() : need_in_words(state)})
    if (!more.empty()) text += " " + more;
  if (state.refusal || !state.placement) return text;
  const Placement& placement = *state.placement;
  const Settings& settings = placement.settings;
  text += " " + count_of(placement.teams.size(), "team", "teams") + " of " +
          std::to_string(placement.requested_teams) + " asked for, method " +
          std::string(name(settings.method)) + ", minimum load ratio " + plain(settings.min_ratio) +
          ".";
  // A list of a hundred teams is no use when it is read out; the JSON has them all.
  const std::size_t named = std::min<std::size_t>(placement.teams.size(), 12);
  const int decimals = coordinate_decimals(placement.vertices);
  for (std::size_t i = 0; i < named; ++i) {
    const TeamInWords team = team_in_words(placement, i, decimals);
    text += " Team " + std::to_string(i + 1) + " at " + team.at[0] + " and " + team.at[1] + ": " +
            team.loads[0] + " and " + team.loads[1] + "\u00A0kg, load ratio " + team.ratio + ".";
  }
  return text;
}

}  // namespace evenlift::view
