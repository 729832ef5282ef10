// Applies commands to the state and recomputes what follows from the document.
#pragma once

#include <string_view>

#include "command.h"
#include "evenlift/result.h"
#include "state.h"

namespace evenlift::view {

// Applies the commands in order and empties the list. Returns whether there were any: then another
// frame is due. A refused document leaves the last good placement standing.
bool apply(AppState& state, Commands& commands);

// Fits the view to the polygon where that is due: at a new document, and after the window or its
// panels changed until somebody pans or zooms. Never while a vertex is dragged.
void frame_view(AppState& state);

// The document that a link, or a link or a polygon's text, holds, if it can be placed; else the
// first error.
Result<Document> read_link(std::string_view link);
Result<Document> read_document(std::string_view text);

// Opens a document as it is at the start of the page: nothing to undo. `work` is an older document
// to which undo leads back, if there is one.
void start_with(AppState& state, Document document, const std::optional<Document>& work);

// Takes over an edited document as one step of undo, or says why it is refused and changes nothing.
std::optional<InputError> try_edit(AppState& state, const Document& edited);

}  // namespace evenlift::view
