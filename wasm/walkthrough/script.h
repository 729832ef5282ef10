// A lesson's stops in the walkthrough, with the teacher's words.
#pragma once

#include <optional>
#include <string>

#include "state/state.h"

namespace evenlift::view {

// Shows only the script's stops, with the teacher's words, from now on. The walkthrough of the
// script's document must be open.
void begin_script(AppState& state, Script script);

// Finds the stops of the script, if there is one, in the trace; a script without stops ends.
void find_stops(Walkthrough& walk);

// Updates the script's position after a jump to any step.
void settle_position(Walkthrough& walk);

// Whether a script is open, and the polygon and its centre of mass are still the script's own.
bool script_is_true(const AppState& state);

// The teacher's words for this step; empty if there are none, or while a question is asked.
std::string words_of_stop(const AppState& state);

}  // namespace evenlift::view
