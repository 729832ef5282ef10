#include "walkthrough/playing.h"

#include <algorithm>
#include <cstdint>
#include <optional>

#include "state/notice.h"
#include "walkthrough/questions.h"
#include "walkthrough/script.h"
#include "walkthrough/timeline.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

std::optional<std::uint32_t> next_step(const AppState& state, int by) {
  const Timeline now = timeline(state);
  const auto wanted = static_cast<std::int64_t>(now.at) + by;
  if (wanted < 0 || wanted >= now.count) return std::nullopt;
  return step_of(state, static_cast<std::uint32_t>(wanted));
}

}  // namespace

void move_steps(AppState& state, int by) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  const auto next = next_step(state, by);
  if (!next) {
    walk.playing = false;
    return;
  }
  const bool asked_already = walk.ask && walk.ask->step == *next;
  if (by > 0 && walk.predict && !asked_already && is_choice(*walk.trace, *next)) {
    ask(state, *next);
    if (walk.ask) return;
  }
  go_to_position(state, timeline(state).at + static_cast<std::uint32_t>(by));
}

void move_chapters(AppState& state, int by) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  const Timeline now = timeline(state);
  const auto chapter = [&](std::uint32_t position) {
    return walk.trace->step(step_of(state, position)).chapter;
  };
  const auto begin = [&](std::uint32_t position) {
    while (position > 0 && chapter(position - 1) == chapter(position)) --position;
    return position;
  };
  if (by < 0) {
    const std::uint32_t own = begin(now.at);
    return go_to_position(state, own < now.at || own == 0 ? own : begin(own - 1));
  }
  std::uint32_t to = now.at;
  while (to + 1 < now.count && chapter(to) == chapter(now.at)) ++to;
  go_to_position(state, to);
}

void set_playing(AppState& state, bool playing) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state)) return;
  if (playing && !next_step(state, 1)) go_to_position(state, 0);
  walk.playing = playing;
  walk.turn_at.reset();
  if (!playing) emit(state, DropFrameAfter{});
}

void set_speed(AppState& state, double speed) {
  state.view.walkthrough.speed = std::clamp(speed, slowest_speed, fastest_speed);
  state.view.walkthrough.turn_at.reset();
}

bool turn_over(AppState& state, double now) {
  Walkthrough& walk = state.view.walkthrough;
  if (!walkthrough_is_open(state) || !walk.playing) return false;
  if (!walk.turn_at) {
    const double letters = static_cast<double>(walk.caption.size() + words_of_stop(state).size());
    const double pause = std::clamp(1 + 0.035 * letters, 1.5, 12.0) / walk.speed;
    walk.turn_at = now + pause;
    emit(state, FrameAfter{pause});
    return false;
  }
  if (now < *walk.turn_at) {
    if (*walk.turn_at - now < 0.05) emit(state, NextFrame{});
    return false;
  }
  move_steps(state, 1);
  emit(state, NextFrame{});
  return true;
}

}  // namespace evenlift::view
