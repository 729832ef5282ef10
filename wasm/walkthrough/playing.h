// Moves through the walkthrough, by hand or automatically.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Moves by `by` of the shown steps: main steps, all steps, or stops of the script. With predictions
// on, a step forward to a choice asks for the choice first (walkthrough/questions.h).
void move_steps(AppState& state, int by);
void move_chapters(AppState& state, int by);

void set_playing(AppState& state, bool playing);
inline constexpr double slowest_speed = 0.25, fastest_speed = 32;  // at 1, there is time to read
void set_speed(AppState& state, double speed);

// While the walkthrough plays: goes to the next step when due. Returns whether it did. `now` is in
// seconds.
bool turn_over(AppState& state, double now);

}  // namespace evenlift::view
