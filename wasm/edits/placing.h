// Places the document anew, and computes what depends on the placement.
#pragma once

#include <functional>

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

// Changes settings that place nothing, in the document and its placement, as an edit. The plan and what is shown of the
// loads follow.
void change_beside(AppState& state, bool live, Edit edit,
                   const std::function<void(Settings&)>& change);

}  // namespace evenlift::view
