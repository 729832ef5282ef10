// The lesson: which step is shown, what is asked, what is answered. Changes AppState::lesson and
// the document's step; everything else is the trace's (evenlift/trace.h).
#pragma once

#include <optional>
#include <string>

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// After each change of the placement: traces it anew if a lesson is open, and keeps the place as
// well as it can. The cost of make_trace(), unless it was `made` before.
void follow_placement(AppState& state, std::optional<Trace> made = std::nullopt);

// Why a step that is asked for cannot be shown; nothing if it can. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

void open_lesson(AppState& state);
void close_lesson(AppState& state);

// O(1) besides look_at() and objects().
void go_to_step(AppState& state, std::uint32_t step);

// To the next step or stop, or one back; with predictions on, forward stops to ask.
void move_steps(AppState& state, int by);
void move_chapters(AppState& state, int by);

void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // 1 is a comfortable pace
void set_speed(AppState& state, double speed);
void set_predict(AppState& state, bool on);
void guess(AppState& state, std::uint32_t answer);
void ask_why(AppState& state, const Vec2& at);
void measure(AppState& state, std::uint32_t candidate);  // shows what the metric measures for it
void leave_script(AppState& state);

// While it plays: turns over when the time has come. `now` in seconds. Returns whether it did.
bool turn_over(AppState& state, double now);

// Shows the lesson's own stops and words from now on: of the document that is open, whose lesson is
// open too.
void begin_script(AppState& state, Script script);

// Begins a lesson of the document that is open, or goes on where it stands, or says why it cannot.
std::optional<InputError> join_script(AppState& state, Script script);

// Whether a ready-made lesson is open, and still of the polygon that it was written for.
bool script_is_true(const AppState& state);

// The figure under the pointer: points first, then lines, then areas. O(figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// The choice of the question under the pointer.
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

// Position on the timeline: steps, or the stops of a ready-made lesson.
struct Timeline {
  std::uint32_t at = 0, count = 1;
};
Timeline timeline(const AppState& state);
std::uint32_t step_of(const AppState& state, std::uint32_t position);

// The teacher's words for this step, or empty.
std::string words_of_stop(const AppState& state);

// Caption, formula and what is asked, for those who cannot see the canvas.
std::string lesson_in_words(const AppState& state);

}  // namespace evenlift::view
