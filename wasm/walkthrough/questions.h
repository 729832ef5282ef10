// The texts around the walkthrough's steps.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "state/state.h"

namespace evenlift::view {

std::string place_in_words(const AppState& state);  // the position: "3 of 15"

// If only the main steps are shown, returns a sentence that says how many steps like this one are
// left out (further_like()): "There are 208 more pairs like it: …". Empty if none are left out,
// if all steps are shown, or while a script or a question is shown.
std::string left_out_in_words(const AppState& state);

// Returns the step's position and chapter, the verdict on the last guess, the teacher's words, the
// caption, the formula, left_out_in_words() and the question, for users who cannot see the canvas;
// empty if no walkthrough is open.
std::string walkthrough_in_words(const AppState& state);

// --- Asks the learner about the next choice, and responds to the answer.

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
