#include "summary.h"

#include <algorithm>

#include "format.h"

namespace evenlift::view {
namespace {

bool selects_candidates(Metric metric) {
  return metric != Metric::distributed && metric != Metric::random;
}

std::string robots(const Placement& placement) {
  const LoadSummary& loads = *placement.loads;
  const int decimals = decimals_for(loads.max);
  return count(placement.teams.size() * 2, "robot", "robots") + ", each " +
         range(loads.min, loads.max, decimals) + "\u202fkg of " + plain(placement.settings.weight) +
         ".";
}

std::string safety(const Placement& placement) {
  if (placement.hull.size() < 3) return "They stand on one line, so the object can tip.";
  return percent(placement.coverage) + " of the object is safe to push on.";
}

std::string shortage(const Placement& placement) {
  if (placement.teams.size() >= placement.requested_teams) return {};
  const std::string wanted = std::to_string(placement.requested_teams);
  if (selects_candidates(placement.settings.metric)) {
    return "Only " + std::to_string(placement.teams.size()) + " of " + wanted +
           " teams find a chord with this load ratio.";
  }
  return "Only " + std::to_string(placement.teams.size()) + " of " + wanted +
         " teams found a place.";
}

std::string join(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + " " + b;
}

Verdict of_placement(const Placement& placement) {
  if (placement.teams.empty()) {
    return {Mood::not_quite, "No team can stand here.",
            "No chord through the centre of mass has this load ratio. Lower the minimum, or move "
            "the centre of mass."};
  }
  Verdict v;
  const std::string few = shortage(placement);
  // Less than half of the object safe to push on is nothing to be content with.
  v.mood = few.empty() && placement.coverage >= 0.5 ? Mood::good : Mood::not_quite;
  v.headline = robots(placement);
  v.detail = join(join(few, safety(placement)), freedom(placement.closure));
  return v;
}

}  // namespace

std::string freedom(const Closure& closure) {
  if (closure.form_closure) return "It cannot move.";
  if (closure.second_order) return "It cannot move, though only just: to second order.";
  const bool clockwise = closure.clockwise.exists, counter = closure.counterclockwise.exists;
  std::string turn;
  if (clockwise && counter)
    turn = "turn both ways";
  else if (clockwise)
    turn = "turn clockwise";
  else if (counter)
    turn = "turn counter-clockwise";
  if (!closure.translation_free) return "It can still " + turn + ".";
  return "It can still " + (turn.empty() ? "slide" : turn + " and slide") + ".";
}

Verdict verdict(const AppState& state) {
  if (state.refusal) {
    return {Mood::refused, sentence(*state.refusal) + ".",
            state.placement ? "The last result is shown dimmed." : ""};
  }
  if (!state.placement) return {Mood::refused, "Nothing is open.", ""};
  return of_placement(*state.placement);
}

std::string summary(const AppState& state) {
  const Verdict v = verdict(state);
  std::string text = join(v.headline, v.detail);
  if (state.refusal || !state.placement) return text;
  const Placement& placement = *state.placement;
  text += " " + count(placement.teams.size(), "team", "teams") + " of " +
          std::to_string(placement.requested_teams) + " asked for, method " +
          std::string(name(placement.settings.metric)) + ", minimum load ratio " +
          fixed(placement.settings.min_ratio, 2) + ".";
  // A screen reader is of no help with a hundred teams; the JSON is.
  const std::size_t named = std::min<std::size_t>(placement.teams.size(), 12);
  for (std::size_t i = 0; i < named; ++i) {
    const Team& team = placement.teams[i];
    const int decimals = decimals_for(placement.loads->max);
    text += " Team " + std::to_string(i + 1) + " at " + point(team.chord.r1.position) + " and " +
            point(team.chord.r2.position) + ": " + fixed(team.loads[0], decimals) + " and " +
            fixed(team.loads[1], decimals) + " kg, load ratio " + fixed(team.chord.ratio, 2) + ".";
  }
  return text;
}

}  // namespace evenlift::view
