// Begins edits. Their consequences are derived after all commands.
#pragma once

#include "state/history.h"
#include "state/state.h"

namespace evenlift::view {

// Records the work for undo. Consecutive live edits, such as those of a drag, are one step.
void begin_edit(AppState& state, bool live, Edit edit);

// Begins an edit, and returns the document to change, which will be placed again. The last notice
// ends, and robots moved by hand go back.
Document& edit(AppState& state, bool live, Edit edit);

// Changes the shown values that differ between `before` and `after`, except the step. The change is
// an edit, unless only overlays differ.
void change_shown(AppState& state, const Shown& before, const Shown& after, bool live = false);

}  // namespace evenlift::view
