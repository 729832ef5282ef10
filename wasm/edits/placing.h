// Places the document anew, and computes what depends on the placement.
#pragma once

#include "evenlift/result.h"
#include "state/history.h"
#include "state/state.h"

namespace evenlift::view {

// What undo keeps beside the document.
Beside beside(const AppState& state);

// Records the document for undo before it is changed. Live edits that follow each other are one step.
void begin_edit(AppState& state, bool live, Edit edit);

// Takes over the placement of the document, or why it is refused. Then call follow_up() and follow_placement().
void adopt(AppState& state, Result<Placement> placement);

// Computes what is shown beside the placement. The best ratio, the plan and the search for balanced
// robots wait for the end of a drag.
void follow_up(AppState& state);

// Places the document anew. Robots that were moved by hand go back, unless they are to stay.
void recompute(AppState& state, bool robots_stay = false);

// Changes what differs between two that may be shown, but the step: as an edit, unless only overlays
// differ. The plan and what is shown of the loads follow.
void change_shown(AppState& state, Shown before, const Shown& after, bool live = false);

}  // namespace evenlift::view
