// Opens documents in place of the one that is open.
#pragma once

#include <optional>

#include "state/history.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// Opens a document as one step of undo.
void open(AppState& state, Opened opened, Edit edit = Edit::opened);

// The same without a step of undo: for a lesson that is being written, say.
void show_opened(AppState& state, Opened opened);

// Opens the first document of the page. There is nothing to undo, unless `work` is given: an older
// document, which undo opens and which is not placed before that.
void start_with(AppState& state, Opened opened, const std::optional<Document>& work);

// Goes on with a document that was refused while it was edited; this is one step of undo.
void resume_draft(AppState& state, Document draft);

}  // namespace evenlift::view
