#include "walkthrough/walkthrough.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "evenlift/output/trace_words.h"
#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "evenlift/why_not.h"
#include "evenlift/wording.h"
#include "state/derived.h"
#include "state/screen.h"

namespace evenlift::view {
namespace {

void ask_why_no_robot(AppState& state, const Vec2& at) {
  Walkthrough& walk = state.view.walkthrough;
  const double reach = (state.session.screen.touch ? 22 : 14) / state.view.camera.scale;
  const WhyNoRobot answer = why_no_robot(*walk.trace, walk.at, at, reach);
  walk.why = why_no_robot_text(*walk.trace, answer);
  walk.why_taken =
      answer.why == WhyNoRobot::Why::stands || answer.why == WhyNoRobot::Why::stands_from_start;
  walk.asked_places = {answer.place.position};
  for (const LiftingPoint& robot : answer.set.came)
    if (!walk.why_taken) walk.asked_places.push_back(robot.position);
  announce(state, walk.why);
}

}  // namespace

void forget_why(Walkthrough& walk) {
  walk.asked.reset();
  walk.asked_places.clear();
  walk.why.clear();
  walk.why_taken = false;
}

void ask_why(AppState& state, const Vec2& at) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  if (walk.trace->balanced()) return ask_why_no_robot(state, at);
  const Trace& trace = *walk.trace;
  const auto& candidates = trace.placement.candidates;
  const double reach = 9 / state.view.camera.scale;
  std::optional<std::uint32_t> nearest;
  double least = reach;
  for (std::uint32_t c = 0; c < candidates.size(); ++c) {
    const Chord& chord = candidates[c].chord;
    const double away = length(nearest_on_segment(chord.r1.position, chord.r2.position, at) - at);
    if (away < least) {
      least = away;
      nearest = c;
    }
  }
  if (!nearest && !inside(trace.placement.vertices(), at)) return forget_why(walk);
  WhyNot answer;
  if (nearest) {
    answer = why_not(trace, walk.at, *nearest);
    walk.asked = candidates[*nearest].chord;
  } else {
    const std::optional<Chord> chord = chord_at(trace, at);
    answer = why_not_chord(trace, walk.at, chord);
    walk.asked = chord;
  }
  walk.why = why_not_text(trace, answer);
  walk.why_taken = answer.why == Why::taken;
  announce(state, walk.why);
}

namespace {

std::string part_of_weight(const std::string& load, const Placement& placement,
                           const Units& units) {
  return say("{load} of {weight}", {load, given_weight(placement.weight(), units)});
}

void add_chord(Explanation& explanation, const Chord& chord, const Units& units) {
  const double longer = std::max(chord.arm1, chord.arm2);
  explanation.rows.push_back(
      {"Distances to the centre of mass",
       say("{arm} and {other_arm}",
           {amount(chord.arm1, longer), with_length_unit(amount(chord.arm2, longer), units)})});
  explanation.rows.push_back({"Load ratio", ratio_in_words(chord.ratio)});
}

// The last swap that moved the team.
std::optional<std::uint32_t> swap_of(const Trace& trace, std::uint32_t team) {
  if (!trace.swaps) return std::nullopt;
  const std::vector<Swap>& swaps = trace.swaps->swaps;
  for (std::size_t i = swaps.size(); i-- > 0;)
    if (std::find(swaps[i].teams.begin(), swaps[i].teams.end(), team) != swaps[i].teams.end())
      return trace.find(StepKind::swap, static_cast<std::uint32_t>(i));
  return std::nullopt;
}

void add_choice(Explanation& explanation, const Trace& trace, std::uint32_t team) {
  if (const auto swap = swap_of(trace, team)) {
    explanation.step = swap;
    explanation.reason = caption(trace, look_at(trace, *swap));
    return;
  }
  explanation.step = trace.find(StepKind::team, team);
  if (!explanation.step) return;
  const StepDetail detail = look_at(trace, *explanation.step);
  if (!detail.scores) {
    explanation.reason = caption(trace, detail);
    return;
  }
  explanation.rows.push_back(
      {"Its chord", say("number {chord} of {chords} possible",
                        {detail.scores->ranking.front() + 1, trace.placement.candidates.size()})});
  explanation.reason = why_here_text(trace, *detail.scores);
}

std::optional<std::uint32_t> step_of_candidate(const Trace& trace, std::uint32_t candidate) {
  const std::uint32_t source = trace.source_of_candidate[candidate];
  if (trace.placement.candidates[candidate].kind == CandidateKind::range) {
    const auto range = std::find(trace.ranges.begin(), trace.ranges.end(), source);
    return trace.find(StepKind::range, static_cast<std::uint32_t>(range - trace.ranges.begin()));
  }
  const auto pairs = static_cast<std::uint32_t>(trace.pairs.size());
  return source < pairs ? trace.find(StepKind::outcome, source)
                        : trace.find(StepKind::opposite, source - pairs);
}

void explain_team(Explanation& explanation, const ShownPlacement& of, const Pick& pick,
                  const Trace* trace) {
  const Placement& placement = of.placement;
  const Team& team = placement.teams[pick.index];
  const TeamInWords words =
      team_in_words(placement, pick.index, coordinate_decimals(placement.vertices()));
  const Units& units = of.shown.units;
  if (pick.kind == Pick::Kind::robot) {
    const auto end = static_cast<std::size_t>(pick.end);
    const std::size_t robot = 2 * pick.index + end;
    if (!pick.second) explanation.robot = robot;
    // The disc shows the team's number; messages about failures name the robot's.
    explanation.title = say("Team {team}: robot {robot} of {robots}",
                            {pick.index + 1, robot + 1, count_robots(placement.teams)});
    explanation.rows.push_back(
        {"It carries",
         part_of_weight(with_weight_unit(words.loads[end], units), placement, units)});
    explanation.rows.push_back(
        {"The other end carries", with_weight_unit(words.loads[1 - end], units)});
  } else {
    explanation.title = say("Team {team}", {pick.index + 1});
    explanation.rows.push_back(
        {"Its robots carry", say("{load} and {other_load} of {weight}",
                                 {words.loads[0], with_weight_unit(words.loads[1], units),
                                  given_weight(placement.weight(), units)})});
  }
  add_chord(explanation, chord_of(team), units);
  if (trace) add_choice(explanation, *trace, static_cast<std::uint32_t>(pick.index));
}

void explain_balanced(Explanation& explanation, const ShownPlacement& of, const Pick& pick) {
  const Placement& placement = of.placement;
  const auto robot = static_cast<std::size_t>(pick.end);
  const TeamInWords words = team_in_words(placement, 0, coordinate_decimals(placement.vertices()));
  const std::size_t all = words.loads.size();
  const Units& units = of.shown.units;
  const std::string load = with_weight_unit(words.loads[robot], units);
  if (!pick.second) explanation.robot = robot;
  explanation.title = say("Robot {robot} of {robots}", {placement.called(robot), all});
  explanation.rows.push_back({"It carries", part_of_weight(load, placement, units)});
  explanation.rows.push_back({"Each of the others", load});
  explanation.rows.push_back({"It stands at", words.at[robot]});
  explanation.reason = say(
      "The centre of mass is the centroid of the {robots} robots. Equal forces at them therefore "
      "add up to the weight and do not turn the object. So all robots can carry the same load, "
      "and they do if they are equally stiff and level.",
      {all});
}

void explain_support(Explanation& explanation, const ShownPlacement& of, const Pick& pick) {
  const Placement& placement = of.placement;
  const auto robot = static_cast<std::size_t>(pick.end);
  const TeamInWords words = team_in_words(placement, 0, coordinate_decimals(placement.vertices()));
  const Units& units = of.shown.units;
  if (!pick.second) explanation.robot = robot;
  explanation.title =
      say("Robot {robot} of {robots}", {placement.called(robot), words.loads.size()});
  if (placement.loads)
    explanation.rows.push_back(
        {"It carries",
         part_of_weight(with_weight_unit(words.loads[robot], units), placement, units)});
  explanation.rows.push_back({"It stands at", words.at[robot]});
  if (const auto capacity = capacity_of(of, robot))
    explanation.rows.push_back({"It can carry", given_weight(*capacity, units)});
  explanation.reason =
      say(placement.teams[0].robots[robot].point.edge == beneath
              ? "It stands beneath the object: it lifts, and touches nothing sideways."
              : "It stands at the edge, where you put it.");
  if (placement.loads && words.loads.size() > 3)
    explanation.reason += " " + say("Loads are those of equally stiff and level robots.");
}

void explain_candidate(Explanation& explanation, const ShownPlacement& of, const Pick& pick,
                       const Trace* trace) {
  const Placement& placement = of.placement;
  explanation.title =
      say("Candidate {candidate} of {candidates}", {pick.index + 1, placement.candidates.size()});
  add_chord(explanation, placement.candidates[pick.index].chord, of.shown.units);
  if (!trace) return;
  const auto candidate = static_cast<std::uint32_t>(pick.index);
  explanation.reason = why_not_text(*trace, why_not(*trace, trace->size() - 1, candidate));
  explanation.step = step_of_candidate(*trace, candidate);
}

}  // namespace

Explanation explain(const AppState& state, const Pick& pick) {
  const Placement& placement = pick.second ? *state.derived().second : *state.derived().placement;
  const ShownPlacement of(placement, shown(state));
  Explanation explanation;
  explanation.of = pick;
  if (placement.settings.method == Method::given) {
    explain_support(explanation, of, pick);
    return explanation;
  }
  if (placement.settings.method == Method::balanced) {
    explain_balanced(explanation, of, pick);
    return explanation;
  }
  // With too long a trace, a placement is explained by its numbers alone.
  const bool moved = !pick.second && by_hand(state);  // not by the algorithm
  std::optional<Result<Trace>> made;
  if (!moved) made = compute_trace(placement, of.shown.units);
  const Trace* trace = made && *made ? &**made : nullptr;
  if (pick.kind == Pick::Kind::candidate)
    explain_candidate(explanation, of, pick, trace);
  else
    explain_team(explanation, of, pick, trace);
  if (pick.second) explanation.step.reset();  // the walkthrough belongs to the first picture
  return explanation;
}

std::string in_words(const Explanation& explanation) {
  std::string text = explanation.title + ".";
  for (const Explanation::Row& row : explanation.rows)
    text += " " + say("{label}: {value}.", {row.label, row.value});
  return text + " " + explanation.reason;
}

std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen) {
  const Walkthrough& walk = state.view.walkthrough;
  if (!walk.ask) return std::nullopt;
  std::optional<std::uint32_t> nearest;
  double least = state.session.screen.touch ? 22 : 12;
  for (const std::uint32_t choice : walk.ask->choices) {
    const Chord& chord = chord_of_choice(*walk.trace, walk.ask->detail, walk.ask->question, choice);
    const Vec2 a = state.view.camera.to_screen(chord.r1.position);
    const Vec2 b = state.view.camera.to_screen(chord.r2.position);
    const double away = length(nearest_on_segment(a, b, screen) - screen);
    if (away < least) {
      least = away;
      nearest = choice;
    }
  }
  return nearest;
}

std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen) {
  const std::vector<Figure>& figures = state.view.walkthrough.figures;
  std::optional<std::size_t> best;
  double best_score = 0;
  // Later figures are above earlier ones.
  for (std::size_t i = figures.size(); i-- > 0;) {
    const Points& p = figures[i].points;
    std::optional<double> score;
    if (p.size() == 1 && figures[i].kind != FigureKind::gain_circle) {
      const double away = length(state.view.camera.to_screen(p[0]) - screen);
      if (away <= 14) score = away;
    } else if (p.size() == 2) {
      const Vec2 a = state.view.camera.to_screen(p[0]), b = state.view.camera.to_screen(p[1]);
      const double away = length(nearest_on_segment(a, b, screen) - screen);
      if (away <= 7) score = 100 + away;
    } else if (p.size() > 2 && inside(p, state.view.camera.to_world(screen))) {
      score = 1000;
    }
    if (score && (!best || *score < best_score)) {
      best_score = *score;
      best = i;
    }
  }
  return best;
}

}  // namespace evenlift::view
