// How an edit begins. What follows from it is derived once all commands are carried out.
#pragma once

#include "state/history.h"
#include "state/state.h"

namespace evenlift::view {

// Records the work for undo before it is changed. Live edits that follow each other are one step.
void begin_edit(AppState& state, bool live, Edit edit);

// Begins an edit and returns the document to be changed. It is placed anew, so the last notice
// ends, and robots that were moved by hand go back.
Document& edit(AppState& state, bool live, Edit edit);

// Changes what differs between two that may be shown, but the step: as an edit, unless only
// overlays differ.
void change_shown(AppState& state, const Shown& before, const Shown& after, bool live = false);

}  // namespace evenlift::view
