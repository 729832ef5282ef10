// Undo and redo, and leaving a lesson, which leads back in the same way.
#pragma once

#include "state/state.h"

namespace evenlift::view {

void undo(AppState& state);
void redo(AppState& state);

// Closes the walkthrough. After a lesson, restores what was open before it, with settings and undo.
// If the user edited something in the lesson, leaving it is a step of undo, and a notice explains
// that. In an <iframe> the lesson's object stays, since nothing was open before it.
void leave_walkthrough(AppState& state);

// The same for the task of a lesson. Without a task nothing happens.
void leave_task(AppState& state);

// Leaves the open lesson or task, if any, because another one opens at once: nothing is placed or
// shown.
void leave_lesson_for_another(AppState& state);

// Forgets a selected or held vertex that no longer exists. O(1).
void drop_stale_picks(AppState& state);

}  // namespace evenlift::view
