// The walkthrough of the algorithm: which step is shown. These functions change View::walkthrough
// and the document's step. What a step shows comes from the trace (evenlift/trace.h).
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/result.h"
#include "state/state.h"

namespace evenlift::view {

// Call after derive(). Shows the step of a new trace that is nearest to the former one, or the one
// that is asked for. Closes the walkthrough if there is no trace any more, and says why there is
// none if one was wanted.
void follow_trace(AppState& state);

// Says why the trace has no such step; nothing if it has. O(1).
std::optional<InputError> check_step(std::uint32_t step, const Trace& trace);

// Opens it where it was left, or at this step, once its trace is derived.
void open_walkthrough(AppState& state, std::optional<std::uint32_t> at = std::nullopt);
void close_walkthrough(AppState& state);

// A step that is no main step is shown among all steps. Costs as much as look_at() and figures().
void go_to_step(AppState& state, std::uint32_t step);

// Goes to a position of the timeline; a script may have several stops at one step. The walkthrough
// must be open.
void go_to_position(AppState& state, std::uint32_t position);

// Shows what is known before the choice that is asked for, and of a pair of edges the sections that
// the question is about, instead of the present step.
void look_before_choice(Walkthrough& walk);
// Shows the present step again, without a question or an answer. Nothing if no walkthrough is open.
void show_step_again(AppState& state);

void show_all_steps(AppState& state, bool all);
void measure(AppState& state, std::uint32_t candidate);  // shows what the metric measures for it

void leave_script(AppState& state);

}  // namespace evenlift::view
