// Answers "Why not this one?" at a point of the drawing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "state/explanation.h"
#include "state/state.h"

namespace evenlift::view {

// For balanced robots, explains why no robot stands at the nearest place of the boundary. For
// teams, explains why the candidate near the point, or else the chord through it, was not chosen.
// If there is no such candidate and the point is outside the polygon, only calls forget_why().
// O(n + K) for K candidates.
void ask_why(AppState& state, const Vec2& at);

// Forgets the question and its answer.
void forget_why(Walkthrough& walk);

// --- Explains why a robot stands where it does, and why a candidate was chosen or not.

// Returns the explanation of a robot, a chord or a candidate of one of the two pictures. Costs at
// most as much as make_trace() and look_at_scores().
Explanation explain(const AppState& state, const Pick& pick);

// Returns the explanation as one text, for users who cannot see the card.
std::string in_words(const Explanation& explanation);

// --- Finds the parts of the walkthrough's drawing that are under the pointer.

// Returns the index of the walkthrough's figure under the pointer, or nothing. Points precede
// lines, and lines precede areas. O(points of the figures).
std::optional<std::size_t> figure_at(const AppState& state, const Vec2& screen);

// Returns the question's choice that is nearest to the pointer, or nothing if all are too far away
// or no question is asked. O(choices).
std::optional<std::uint32_t> choice_at(const AppState& state, const Vec2& screen);

}  // namespace evenlift::view
