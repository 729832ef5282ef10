// The walkthrough: steps, scripts, questions, answers and explanations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "evenlift/result.h"
#include "state/state.h"
#include "state/view_state.h"

namespace evenlift::view {

// --- Answers "Why not this one?" at a point of the drawing.

// For balanced robots, explains why no robot stands at the nearest place of the boundary. For
// teams, explains why the candidate near the point, or else the chord through it, was not chosen.
// If there is no such candidate and the point is outside the polygon, only calls forget_why().
// O(n + K) for K candidates.
void ask_why(AppState& state, const Vec2& at);

// Forgets the question and its answer.
void forget_why(Walkthrough& walk);

// --- Explains why a robot stands where it does, and why a candidate was chosen or not.

// Returns the explanation of a robot, a chord or a candidate of one of the two pictures. Costs at
// most as much as make_trace() and look_at_scores().
Explanation explain(const AppState& state, const Pick& pick);

// Returns the explanation as one text, for users who cannot see the card.
std::string in_words(const Explanation& explanation);

// --- Finds the parts of the walkthrough's drawing that are under the pointer.

// Returns the index of the walkthrough's figure under the pointer, or nothing. Points precede
// lines, and lines precede areas. O(points of the figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// Returns the question's choice that is nearest to the pointer, or nothing if all are too far away
// or no question is asked. O(choices).
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

// --- The texts around the walkthrough's steps.

std::string place_in_words(const AppState& state);  // the position: "3 of 15"

// If only the main steps are shown, returns a sentence that says how many steps like this one are
// left out (further_like()): "There are 208 more pairs like it: …". Empty if none are left out,
// if all steps are shown, or while a script or a question is shown.
std::string left_out_in_words(const AppState& state);

// Returns the step's position and chapter, the verdict on the last guess, the teacher's words, the
// caption, the formula, left_out_in_words() and the question, for users who cannot see the canvas;
// empty if no walkthrough is open.
std::string walkthrough_in_words(const AppState& state);

// --- Asks the learner about the next choice, and responds to the answer.

// The greatest number of questions of each kind; later choices are shown without a question.
inline constexpr std::size_t most_questions = 3;

// Turns predictions on or off. While they are on, the learner is asked before a choice is shown. If
// no shown step has a choice to ask for, predictions stay off, and a notice reports this.
void set_predict(AppState& state, bool on);

// Asks for the choice that this step shows, unless the step shows none, the choice is trivial, or
// questions of its kind were asked at most_questions other steps.
void ask(AppState& state, std::uint32_t step);

// Goes to the question's step, and reports whether the answer was right.
void guess(AppState& state, std::uint32_t answer);

// Returns whether a question concerns balanced robots that the present step does not show. If so,
// only these robots and the chords to choose from are drawn.
bool asks_of_other_robots(const AppState& state);

// --- The timeline counts the shown steps: the main steps, all steps, or the stops of a script.

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
// on, a step forward to a choice asks for the choice first (walkthrough/walkthrough.h).
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
