// Applies commands to the state and recomputes what follows from the document.
#pragma once

#include "evenlift/result.h"
#include "state/command.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any: then another
// frame is due. A refused document leaves the last good placement standing.
bool apply(AppState& state, Commands& commands);

// Fits the view to the polygon where that is due: at a new document, and after the window or its
// panels changed until somebody pans or zooms. Never while a vertex is dragged.
void frame_view(AppState& state);

// Opens a document as it is at the start of the page: nothing to undo. `work` is an older document
// to which undo leads back, if there is one; it is not placed before.
void start_with(AppState& state, Opened opened, const std::optional<Document>& work);

// Goes on with what was being edited when it was refused, as one step of undo.
void resume_draft(AppState& state, Document draft);

// Takes over an edited document as one step of undo, or says why it is refused and changes nothing.
// Another step of the lesson alone is no edit, and computes nothing.
std::optional<InputError> try_edit(AppState& state, const Document& edited);

}  // namespace evenlift::view
