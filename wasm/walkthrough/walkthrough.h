// Opens and closes the walkthrough, and changes the step that it shows. These functions change
// View::walkthrough and the document's step. A step's content comes from the trace
// (evenlift/trace.h).
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Follows the derived trace; call this after derive(). Shows the requested step of a new trace, or
// the step nearest to the former one. If there is no trace, closes the walkthrough and, if a trace
// was requested, reports why it is missing.
void follow_trace(AppState& state);

// Returns the error if the trace has no such step. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

// Opens the walkthrough where the user left it, or at the step `at`, once its trace is derived.
void open_walkthrough(AppState& state, std::optional<std::uint32_t> at = std::nullopt);
void close_walkthrough(AppState& state);

// Goes to a step. If it is not a main step and no script is open, all steps are shown from now on.
// Costs as much as look_at() and figures().
void go_to_step(AppState& state, std::uint32_t step);

// Goes to a position of the timeline; a script may have several stops at one step. Precondition:
// the walkthrough is open.
void go_to_position(AppState& state, std::uint32_t position);

// Shows the results known before the choice in question, instead of the present step; for an edge
// pair, the sections in question as well.
void look_before_choice(Walkthrough& walk);
// Shows the step without a question or an answer. Does nothing if no walkthrough is open.
void show_step_again(AppState& state);

// Shows all steps, or only the main steps or the stops of the script that was set aside.
void show_all_steps(AppState& state, bool all);
void measure(AppState& state, std::uint32_t candidate);  // shows the candidate's gain

// Leaves the script and continues without the teacher's words.
void leave_script(AppState& state);

}  // namespace evenlift::view
