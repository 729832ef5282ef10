// Opens documents in place of the open one.
#pragma once

#include <optional>

#include "state/history.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// Opens a document as one step of undo.
void open(AppState& state, Opened opened, Edit edit = Edit::opened);

// Opens a document without a step of undo, for instance the preview of a lesson.
void show_opened(AppState& state, Opened opened);

// Opens the page's first document. There is nothing to undo, unless `work` is given: an older
// document, which undo opens and only then places.
void start_with(AppState& state, Opened opened, const std::optional<Document>& work);

// Continues with a document that was refused while it was being edited, as one step of undo.
void resume_draft(AppState& state, Document draft);

}  // namespace evenlift::view
