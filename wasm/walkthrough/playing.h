// Moves through the walkthrough, by hand or automatically.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Moves by a number of shown steps: main steps, all steps, or stops of the script. With predictions
// on, a step forward to a choice asks for the choice first (walkthrough/questions.h).
void move_steps(AppState& state, int by);
// Moves to the next chapter, or back to the beginning of this chapter or of the preceding one.
void move_chapters(AppState& state, int by);

// Begins or ends playing. At the last step, playing begins again at the first step.
void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // 1 leaves time to read
// Sets the speed within these bounds.
void set_speed(AppState& state, double speed);

// Goes to the next step when it is due, while the walkthrough plays. Returns whether the step
// changed. `now` is in seconds.
bool turn_over(AppState& state, double now);

}  // namespace evenlift::view
