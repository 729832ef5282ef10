// Shows a lesson's stops in the walkthrough, with the teacher's words.
#pragma once

#include <optional>
#include <string>

#include "state/state.h"

namespace evenlift::view {

// Begins a script: from now on, only its stops are shown. Precondition: the walkthrough of the
// script's document is open.
void begin_script(AppState& state, Script script);

// Finds the script's stops in the trace. A script without stops ends.
void find_stops(Walkthrough& walk);

// Updates the script's position after a jump to another step.
void settle_position(Walkthrough& walk);

// Returns whether a script is open and the polygon and the centre of mass are still the script's.
bool script_is_true(const AppState& state);

// Returns the teacher's words for this step; if the shape or a setting differs from the script's,
// the remark that the words no longer apply. Empty at a step without words, and while a question is
// asked.
std::string words_of_stop(const AppState& state);

}  // namespace evenlift::view
