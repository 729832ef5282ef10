// A lesson's stops in the walkthrough, with the teacher's words.
#pragma once

#include <optional>
#include <string>

#include "state/state.h"

namespace evenlift::view {

// From now on, only the script's stops are shown. The walkthrough of its document must be open.
void begin_script(AppState& state, Script script);

// Finds the stops in the trace. A script without stops ends.
void find_stops(Walkthrough& walk);

// Updates the script's position after a jump.
void settle_position(Walkthrough& walk);

// Whether a script is open, and the polygon and its centre of mass are still its own.
bool script_is_true(const AppState& state);

// For this step; empty if there are none, or while a question is asked.
std::string words_of_stop(const AppState& state);

}  // namespace evenlift::view
