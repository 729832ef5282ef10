// The walkthrough of the algorithm: which step is shown, what is asked, what is answered. These
// functions change AppState::walkthrough and the document's step. What a step shows comes from the
// trace (evenlift/trace.h).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "state/command.h"
#include "state/state.h"

namespace evenlift::view {

// Call after each change of the placement. Traces it again if the walkthrough is open, and shows
// the step that is nearest to the former one. Costs as much as make_trace(), unless the trace was
// `made` before.
void follow_placement(AppState& state, std::optional<Trace> made = std::nullopt);

// Says why the trace has no such step; nothing if it has. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

// Opens it where it was left, or at this step.
void open_walkthrough(AppState& state, std::optional<std::uint32_t> at = std::nullopt);
void close_walkthrough(AppState& state);

// A step that is no main step is shown among all steps. Costs as much as look_at() and figures().
void go_to_step(AppState& state, std::uint32_t step);

// Goes `by` of the steps that are shown forward: main steps, all steps, or stops of the script. With predictions on, a step
// forward that shows a choice asks for it first, if the choice is not trivial; of each kind of question only the first
// most_questions are asked.
inline constexpr std::size_t most_questions = 3;
void move_steps(AppState& state, int by);
void move_chapters(AppState& state, int by);

void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // 1 leaves time to read
void set_speed(AppState& state, double speed);
void set_predict(AppState& state, bool on);
void guess(AppState& state, std::uint32_t answer);
void ask_why(AppState& state, const Vec2& at);
void measure(AppState& state, std::uint32_t candidate);  // shows what the metric measures for it
void leave_script(AppState& state);
void show_all_steps(AppState& state, bool all);

// While the walkthrough plays: goes to the next step when its time has come, and returns whether it
// did. `now` is in seconds.
bool turn_over(AppState& state, double now);

// From now on only the script's stops are shown, with the teacher's words. The walkthrough of the
// script's document must be open.
void begin_script(AppState& state, Script script);

// Begins a script for the document that is open, or joins its walkthrough at the present step; or
// says why it cannot.
std::optional<InputError> join_script(AppState& state, Script script);

// Whether settings are the same but for what is shown and the step of the walkthrough. O(1).
bool same_settings(Settings a, const Settings& b);

// The settings that the script found, if those in force are still its own.
std::optional<Settings> settings_before_script(const AppState& state);

// Whether a script is open, and the polygon is still the one that it was written for.
bool script_is_true(const AppState& state);

// The figure under the pointer. Points come before lines, and lines before areas. O(figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// The choice of the question under the pointer.
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

// The position on the timeline, which counts the steps that are shown: the main ones, all, or the stops of a script.
struct Timeline {
  std::uint32_t at = 0, count = 1;
};
Timeline timeline(const AppState& state);
std::string place_in_words(const AppState& state);  // "3 of 15"
std::uint32_t step_of(const AppState& state, std::uint32_t position);
// Nothing if the step is not among those that are shown.
std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step);

// The chapters on the timeline, each of the same width whatever its number of steps; those of a script are one. Positions
// begin at `first`.
struct ChapterPart {
  std::uint32_t first = 0, count = 0;
};
std::vector<ChapterPart> chapter_parts(const AppState& state);
// The share of the timeline (0 .. 1) at which a position lies, and the position that is nearest to a share.
double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position);
std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share);

// The teacher's words for this step; empty if there are none.
std::string words_of_stop(const AppState& state);

// What the main steps leave out after this one: "and 208 more pairs like it"; empty if nothing.
std::string left_out_in_words(const AppState& state);

// Caption, formula and question, for those who cannot see the canvas.
std::string walkthrough_in_words(const AppState& state);

}  // namespace evenlift::view
