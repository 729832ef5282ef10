// Answers "Why not this one?" at a point of the drawing.
#pragma once

#include "state/state.h"

namespace evenlift::view {

// Explains why the candidate near the point, or else the chord through the point, was not chosen.
// For balanced robots, explains why no robot stands at the nearest place of the boundary. For
// teams, a point outside the polygon and near no candidate asks nothing. O(n + K) for K candidates.
void ask_why(AppState& state, const Vec2& at);

// Forgets the question and its answer.
void forget_why(Walkthrough& walk);

}  // namespace evenlift::view
