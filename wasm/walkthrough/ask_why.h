// "Why not this one?", asked at a point of the drawing.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Why the candidate near the point, or else the chord through it, was not taken; of balanced
// robots, why none stands at the place of the boundary that is nearest. O(n + K) for K candidates.
// A place away from the object asks nothing.
void ask_why(AppState& state, const Vec2& at);

// Takes the question and its answer away.
void forget_why(Walkthrough& walk);

}  // namespace evenlift::view
