// Opens and closes the walkthrough, and changes the step that it shows. These functions change
// View::walkthrough and the document's step. A step's content comes from the trace
// (evenlift/trace.h).
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

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
