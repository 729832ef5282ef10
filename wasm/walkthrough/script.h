// A lesson's stops in the walkthrough, with the teacher's words.
#pragma once

#include <optional>
#include <string>

#include "state/state.h"

namespace evenlift::view {

// From now on only the script's stops are shown, with the teacher's words. The walkthrough of the
// script's document must be open.
void begin_script(AppState& state, Script script);

// Finds the stops of the script, if there is one, in the trace; without any it ends.
void find_stops(Walkthrough& walk);

// Finds the stop for a step that was not reached from stop to stop.
void settle_position(Walkthrough& walk);

// Whether a script is open, and the polygon and its centre of mass are still those that it was
// written for.
bool script_is_true(const AppState& state);

// The teacher's words for this step; empty if there are none, or while a question is asked.
std::string words_of_stop(const AppState& state);

}  // namespace evenlift::view
