// Answers "Why not this one?" at a point of the drawing.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Explains why the candidate near the point, or else the chord through it, was not chosen; for
// balanced robots, why no robot stands at the nearest place of the boundary. O(n + K) for K
// candidates. A point away from the object asks nothing.
void ask_why(AppState& state, const Vec2& at);

// Also forgets the answer.
void forget_why(Walkthrough& walk);

}  // namespace evenlift::view
