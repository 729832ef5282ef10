// How an edit begins. Its consequences are derived after all commands.
#pragma once

#include "state/history.h"
#include "state/state.h"

namespace evenlift::view {

// Records the work for undo before a change. Consecutive live edits are one step.
void begin_edit(AppState& state, bool live, Edit edit);

// Begins an edit and returns the document to change. The document will be placed again, so the last
// notice ends, and robots that were moved by hand go back.
Document& edit(AppState& state, bool live, Edit edit);

// Applies the difference between two values of Shown, except the step. This is an edit, unless only
// overlays differ.
void change_shown(AppState& state, const Shown& before, const Shown& after, bool live = false);

}  // namespace evenlift::view
