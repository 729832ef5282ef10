// The texts around the walkthrough's steps.
#pragma once

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

}  // namespace evenlift::view
