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
// Lays a picture behind the drawing, at this place in polygon coordinates, shows all of it and begins to draw; or ends that.
void lay_behind(AppState& state, const std::optional<Box>& picture);

void frame_view(AppState& state);

// Opens the first document of the page. There is nothing to undo, unless `work` is given: an older
// document, which undo opens and which is not placed before that.
void start_with(AppState& state, Opened opened, const std::optional<Document>& work);

// Shows a document in place of the one that is open, which is no step of undo: a lesson that is being
// written, say.
void reopen(AppState& state, Opened opened);

// Goes on with a document that was refused while it was edited; this is one step of undo.
void resume_draft(AppState& state, Document draft);

// Takes over an edited document as one step of undo; or says why it is refused, and changes nothing. If only
// the step of the walkthrough differs, that is no edit; and nothing is placed if only that differs, what a
// robot carries or how well the centre of mass is known. It is also refused if the placement has no robot with the number `failed`, from 1.
std::optional<InputError> try_edit(AppState& state, const Document& edited,
                                   std::uint64_t failed = 0);

}  // namespace evenlift::view
