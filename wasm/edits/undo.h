// Undo and redo, and leaving a lesson, which leads back in the same way.
#pragma once

#include "state/state.h"

namespace evenlift::view {

void undo(AppState& state);
void redo(AppState& state);

// After a lesson, restores what was open before it, with settings and undo. After an edit in the
// lesson, leaving it is a step of undo, and a notice explains that. In an <iframe> the lesson's
// object stays, since nothing was open before.
void leave_walkthrough(AppState& state);

// The same for the task of a lesson, if one is open.
void leave_task(AppState& state);

// Another lesson opens at once, so nothing is placed or shown.
void leave_lesson_for_another(AppState& state);

// Forgets a selected or held vertex that no longer exists. O(1).
void drop_stale_picks(AppState& state);

}  // namespace evenlift::view
