#include "summary.h"

#include <algorithm>

#include "format.h"
#include "lesson.h"
#include "methods.h"

namespace evenlift::view {
namespace {

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

Verdict of_placement(const Placement& placement, const std::optional<double>& capacity) {
  if (placement.teams.empty()) {
    return {Mood::not_quite, "No team can stand here.",
            "No chord through the centre of mass has this load ratio. Lower the minimum, or move "
            "the centre of mass."};
  }
  Verdict v;
  const std::string few = shortage(placement);
  // Less than half of the object safe to push on is nothing to be content with.
  v.mood = few.empty() && placement.coverage >= 0.5 ? Mood::good : Mood::not_quite;
  if (capacity && placement.loads->max > *capacity) v.mood = Mood::not_quite;
  v.headline = robots(placement);
  v.detail = join(join(few, safety(placement)), freedom(placement.closure));
  return v;
}

Verdict of_drawing(const AppState& state) {
  const std::size_t n = state.drawing.points.size();
  const std::string press = state.screen.touch ? "Tap" : "Click";
  if (n == 0) return {Mood::drawing, "Draw a shape.", press + " where its first vertex is."};
  return {Mood::drawing, count(n, "vertex", "vertices") + " so far.",
          n < 3 ? "A shape needs at least three." : press + " the first one to close the shape."};
}

}  // namespace

std::string freedom(const Closure& closure) {
  if (closure.form_closure) return "It cannot move.";
  if (closure.second_order) return "It cannot move, though only just: to second order.";
  // A region that lies far away, or is but a point, is not there to be pointed at.
  const auto about = [](const FreeRegion& region, const char* colour) {
    return region.clipped.size() >= 3 ? std::string(" about the ") + colour + " region"
                                      : std::string();
  };
  const bool clockwise = closure.clockwise.exists, counter = closure.counterclockwise.exists;
  std::string turn;
  if (clockwise && counter)
    turn = "turn both ways";
  else if (clockwise)
    turn = "turn clockwise" + about(closure.clockwise, "red");
  else if (counter)
    turn = "turn counter-clockwise" + about(closure.counterclockwise, "blue");
  if (!closure.translation_free) return "It can still " + turn + ".";
  const std::string slide = closure.translation ? "slide along the arrow" : "slide";
  return "It can still " + (turn.empty() ? slide : turn + ", and " + slide) + ".";
}

std::string need_in_words(const AppState& state) {
  if (!state.capacity || !state.placement) return {};
  const Placement& placement = *state.placement;
  std::size_t over = 0;
  for (const Team& team : placement.teams) {
    for (const double load : team.loads) over += load > *state.capacity ? 1u : 0u;
  }
  std::string text = over == 0 ? "Each robot stays within it."
                               : count(over, "robot carries", "robots carry") + " more than that.";
  if (!state.plan) return text;
  const CapacityPlan& plan = *state.plan;
  if (plan.possible) {
    return text + " Needed with this method: " + count(2 * plan.teams, "robot", "robots") +
           ", the heaviest load " + weight(plan.greatest_load, decimals_for(plan.greatest_load)) +
           ".";
  }
  if (plan.tried >= most_teams_for_capacity) {
    return text + " Even " + std::to_string(2 * plan.tried) + " robots are too few.";
  }
  return text + " Not even all " + std::to_string(plan.tried) +
         " teams that find a place are enough.";
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
  if (lesson_is_open(state) && !state.refusal) return lesson_in_words(state);
  std::string text = join(join(v.headline, v.detail), state.refusal ? "" : need_in_words(state));
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
