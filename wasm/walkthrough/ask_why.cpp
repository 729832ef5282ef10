#include "walkthrough/ask_why.h"

#include <cstdint>
#include <optional>

#include "evenlift/output/words.h"
#include "evenlift/plane.h"
#include "state/notice.h"

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

}  // namespace evenlift::view
