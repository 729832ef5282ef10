// Undo and redo, and the way out of a lesson, which leads back as undo does.
#pragma once

#include "state/state.h"

namespace evenlift::view {

void undo(AppState& state);
void redo(AppState& state);

// Closes the walkthrough. After a lesson what was open before it comes back, with its settings and
// its undo. If something was edited in the lesson, leaving it is a step of undo, and a notice says
// so. In an <iframe> the lesson's object stays, as nothing was open before it.
void leave_walkthrough(AppState& state);

// Leaves the lesson that is open, if one is, for another one that is opened at once: nothing is
// placed or shown.
void leave_lesson_for_another(AppState& state);

// Forgets a selection of, or a grip on, a vertex that no longer exists. O(1).
void drop_stale_picks(AppState& state);

}  // namespace evenlift::view
