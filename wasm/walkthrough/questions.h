// Questions to the learner about the next choice, and the response to the answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/state.h"

namespace evenlift::view {

// Of each kind.
inline constexpr std::size_t most_questions = 3;

void set_predict(AppState& state, bool on);

// Asks for the choice that this step shows, unless it is trivial.
void ask(AppState& state, std::uint32_t step);

// Goes to the question's step, and reports whether the answer was right.
void guess(AppState& state, std::uint32_t answer);

// Whether a question concerns balanced robots that the present step does not show. Then only these
// and the chords to choose from are drawn.
bool asks_of_other_robots(const AppState& state);

}  // namespace evenlift::view
