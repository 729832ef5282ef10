// The timeline counts the shown steps: the main steps, all steps, or the stops of a script.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

struct Timeline {
  std::uint32_t at = 0, count = 1;  // the present position, from 0, and the number of positions
};
Timeline timeline(const AppState& state);
// Returns the step at a position.
std::uint32_t step_of(const AppState& state, std::uint32_t position);
// Returns the position of a step; nothing if the timeline does not show the step.
std::optional<std::uint32_t> position_of(const AppState& state, std::uint32_t step);

// A chapter's part of the timeline: `count` positions that begin at `first`. All parts have the
// same width, whatever their number of steps. A script is one chapter.
struct ChapterPart {
  std::uint32_t first = 0, count = 0;
};
std::vector<ChapterPart> chapter_parts(const AppState& state);
// share_of() returns the place of a position as a fraction of the timeline's width (0 .. 1), and
// position_at() the position nearest to a fraction.
double share_of(const std::vector<ChapterPart>& parts, std::uint32_t position);
std::uint32_t position_at(const std::vector<ChapterPart>& parts, double share);

// --- Shows a lesson's stops in the walkthrough, with the teacher's words.

// Begins a script: from now on, only its stops are shown. Precondition: the walkthrough of the
// script's document is open.
void begin_script(AppState& state, Script script);

// Finds the script's stops in the trace. If the trace contains none, the script ends.
void find_stops(Walkthrough& walk);

// Updates the script's position after a jump to another step.
void settle_position(Walkthrough& walk);

// Returns whether a script is open and the polygon and the centre of mass are still the script's.
bool script_is_true(const AppState& state);

// Returns the teacher's words for this step or, if the shape or a setting differs from the
// script's, a remark that the words no longer apply. Empty at a step without words, while a
// question is asked, and without a script.
std::string words_of_stop(const AppState& state);

// --- Moves through the walkthrough, by hand or automatically.

// Moves by a number of shown steps: main steps, all steps, or stops of the script. With predictions
// on, a step forward to a choice asks for the choice first (walkthrough/questions.h).
void move_steps(AppState& state, int by);
// If `by` is negative, moves back to the beginning of this chapter or, if already there, of the
// preceding one. Otherwise moves to the next chapter or, in the last chapter, to the last step.
void move_chapters(AppState& state, int by);

// Begins or ends playing. From the last step, playing begins again at the first step.
void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // speed 1 leaves time to read
// Sets the speed within these bounds.
void set_speed(AppState& state, double speed);

// While the walkthrough plays, goes to the next step when this step is due. Returns whether it was
// due; move_steps() may then ask a question or end playing instead. `now` is in seconds.
bool turn_over(AppState& state, double now);

// --- Opens and closes the walkthrough, and changes the step that it shows. These functions change
// View::walkthrough and the document's step. A step's content comes from the trace
// (evenlift/trace.h).

// Follows the derived trace; call this after derive(). If the trace is new, shows the requested
// step or, if this is the step already shown, the new trace's step nearest to it. If there is no
// trace, closes the walkthrough and, if a trace was requested, reports why it is missing.
void follow_trace(AppState& state);

// Returns an error if the trace has no such step; otherwise nothing. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

// Opens the walkthrough where the user left it, or at the step `at`, once its trace is derived.
void open_walkthrough(AppState& state, std::optional<std::uint32_t> at = std::nullopt);
void close_walkthrough(AppState& state);

// Goes to a step. If the step is not a main step and no script is open, all steps are shown from
// now on. Costs as much as look_at() and figures().
void go_to_step(AppState& state, std::uint32_t step);

// Goes to a position of the timeline. In a script, several positions may have the same step.
// Precondition: the walkthrough is open.
void go_to_position(AppState& state, std::uint32_t position);

// Shows the results known before the choice that the question asks for, instead of the present
// step. For an edge pair, also shows the edges and their sections. Precondition: a question is
// open.
void look_before_choice(Walkthrough& walk);
// Shows the present step without a question or an answer. Does nothing if no walkthrough is open.
void show_step_again(AppState& state);

// Shows all steps and sets an open script aside; or, if `all` is false, shows only the stops of the
// script that was set aside or, without one, the main steps.
void show_all_steps(AppState& state, bool all);
void measure(AppState& state, std::uint32_t candidate);  // shows the candidate's gain

// Leaves the script and continues without the teacher's words.
void leave_script(AppState& state);

}  // namespace evenlift::view
