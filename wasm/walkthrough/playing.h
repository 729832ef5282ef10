// Moves through the walkthrough, by hand or automatically.
#pragma once

#include "state/state.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
