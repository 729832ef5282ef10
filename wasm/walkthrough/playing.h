// Going forward and back through the walkthrough, by hand or by itself.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Goes `by` of the steps that are shown forward: main steps, all steps, or stops of the script.
// With predictions on, a step forward that shows a choice asks for it first
// (walkthrough/questions.h).
void move_steps(AppState& state, int by);
void move_chapters(AppState& state, int by);

void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // 1 leaves time to read
void set_speed(AppState& state, double speed);

// While the walkthrough plays: goes to the next step when its time has come, and returns whether it
// did. `now` is in seconds.
bool turn_over(AppState& state, double now);

}  // namespace evenlift::view
