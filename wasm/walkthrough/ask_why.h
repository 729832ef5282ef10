// Answers "Why not this one?" at a point of the drawing.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// For balanced robots, explains why no robot stands at the nearest place of the boundary. For
// teams, explains why the candidate near the point, or else the chord through it, was not chosen.
// If there is no such candidate and the point is outside the polygon, only calls forget_why().
// O(n + K) for K candidates.
void ask_why(AppState& state, const Vec2& at);

// Forgets the question and its answer.
void forget_why(Walkthrough& walk);

}  // namespace evenlift::view
