// Asks the learner about the next choice, and responds to the answer.
#pragma once

#include <cstddef>
#include <cstdint>

#include "state/state.h"

namespace evenlift::view {

// The greatest number of questions of each kind; later choices are shown without a question.
inline constexpr std::size_t most_questions = 3;

// Turns predictions on or off. While they are on, the learner is asked before a choice is shown. If
// no shown step has a choice to ask for, predictions stay off, and a notice reports this.
void set_predict(AppState& state, bool on);

// Asks for the choice that this step shows, unless the step shows none, the choice is trivial, or
// questions of its kind were asked at most_questions other steps.
void ask(AppState& state, std::uint32_t step);

// Goes to the question's step, and reports whether the answer was right.
void guess(AppState& state, std::uint32_t answer);

// Returns whether a question concerns balanced robots that the present step does not show. If so,
// only these robots and the chords to choose from are drawn.
bool asks_of_other_robots(const AppState& state);

}  // namespace evenlift::view
