// Undo, redo, and the return from a lesson to the work before it.
#pragma once

#include "state/state.h"

namespace evenlift::view {

void undo(AppState& state);
void redo(AppState& state);

// Leaves the walkthrough. If it belongs to a lesson, restores the document that was open before the
// lesson, with its settings and steps of undo. After an edit in the lesson, leaving the lesson is
// itself a step of undo, and a notice says so. In an <iframe> the lesson's object stays, since
// nothing was open before.
void leave_walkthrough(AppState& state);

// Leaves the task of a lesson in the same way, if a task is open.
void leave_task(AppState& state);

// Leaves a lesson because another one opens at once, so nothing is placed or shown.
void leave_lesson_for_another(AppState& state);

// Forgets a selected, hovered or held vertex, edge or weight that no longer exists. O(1).
void drop_stale_picks(AppState& state);

}  // namespace evenlift::view
