// The walkthrough, and the step that it shows. These functions change View::walkthrough and the
// document's step. A step's content comes from the trace (evenlift/trace.h).
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Call after derive(). Shows the requested step of a new trace, or the step nearest to the former
// one. Without a trace, closes the walkthrough and, if a trace was requested, reports why it is
// missing.
void follow_trace(AppState& state);

// The error if the trace has no such step. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

// Opens it where the user left it, or at this step, once its trace is derived.
void open_walkthrough(AppState& state, std::optional<std::uint32_t> at = std::nullopt);
void close_walkthrough(AppState& state);

// A step that is not a main step is shown among all steps. Costs as much as look_at() and
// figures().
void go_to_step(AppState& state, std::uint32_t step);

// Goes to a position of the timeline; a script may have several stops at one step. Precondition:
// the walkthrough is open.
void go_to_position(AppState& state, std::uint32_t position);

// Shows what is known before the choice in question, not the present step; for an edge pair, also
// the sections in question.
void look_before_choice(Walkthrough& walk);
// Shows the step without a question or an answer. Does nothing without a walkthrough.
void show_step_again(AppState& state);

void show_all_steps(AppState& state, bool all);
void measure(AppState& state, std::uint32_t candidate);  // shows its gain

void leave_script(AppState& state);

}  // namespace evenlift::view
