// Applies commands to the state, and computes again what depends on the document.
#pragma once

#include "evenlift/result.h"
#include "state/command.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any; then another
// frame is due. When a document is refused, the last good placement stays.
bool apply(AppState& state, Commands& commands);

// Fits the view to the polygon if that is due: for a new document, and until somebody pans or zooms
// also after the window or its panels changed. Never during a drag.
void frame_view(AppState& state);

// Opens the first document of the page. There is nothing to undo, unless `work` is given: an older
// document, which undo opens and which is not placed before that.
void start_with(AppState& state, Opened opened, const std::optional<Document>& work);

// Goes on with a document that was refused while it was edited; this is one step of undo.
void resume_draft(AppState& state, Document draft);

// Takes over an edited document as one step of undo; or says why it is refused, and changes
// nothing. If only the step of the walkthrough differs, that is no edit, and nothing is computed.
std::optional<InputError> try_edit(AppState& state, const Document& edited);

}  // namespace evenlift::view
