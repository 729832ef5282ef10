// Shows a lesson's stops in the walkthrough, with the teacher's words.
#pragma once

#include <optional>
#include <string>

#include "state/state.h"

namespace evenlift::view {

// Begins a script: from now on, only its stops are shown. Precondition: the walkthrough of the
// script's document is open.
void begin_script(AppState& state, Script script);

// Finds the script's stops in the trace. If the trace contains none, the script ends.
void find_stops(Walkthrough& walk);

// Updates the script's position after a jump to another step.
void settle_position(Walkthrough& walk);

// Returns whether a script is open and the polygon and the centre of mass are still the script's.
bool script_is_true(const AppState& state);

// Returns the teacher's words for this step or, if the shape or a setting differs from the
// script's, a remark that the words no longer apply. Empty at a step without words, while a
// question is asked, and without a script.
std::string words_of_stop(const AppState& state);

}  // namespace evenlift::view
