#pragma once

#include <string>

#include "state/state.h"

namespace evenlift::view {

std::string place_in_words(const AppState& state);  // "3 of 15"

// By the main steps, after this one: "and 208 more pairs like it"; or empty.
std::string left_out_in_words(const AppState& state);

// Caption, formula and question, for users who cannot see the canvas.
std::string walkthrough_in_words(const AppState& state);

}  // namespace evenlift::view
