// What the learner is asked about the next choice, and what is said to the answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/state.h"

namespace evenlift::view {

// Of each kind of question only the first ones are asked.
inline constexpr std::size_t most_questions = 3;

void set_predict(AppState& state, bool on);

// Asks for the choice that this step shows, if it is not trivial.
void ask(AppState& state, std::uint32_t step);

// Goes to the step of the question, and says whether the answer was right.
void guess(AppState& state, std::uint32_t answer);

// Whether a question is asked about balanced robots that the present step does not show. Then only
// these are drawn, and the chords to choose from.
bool asks_of_other_robots(const AppState& state);

}  // namespace evenlift::view
