// The visible part of the plane.
#pragma once

#include <optional>

#include "state/history.h"
#include "state/opened.h"
#include "state/state.h"

namespace evenlift::view {

// From now on, the view fits the window, until the user pans or zooms.
void fit_view(AppState& state);

// Fits the view to the polygon if that is due. Does nothing during a drag, or while a drawing tool
// is selected (if there is a picture behind the drawing, only once a vertex is drawn). Fitting is
// due for a new document and, until the user pans or zooms, after the window or its panels change.
void frame_view(AppState& state);

// Takes this camera, but keeps its scale between the smallest and the largest zoom.
void look_through(AppState& state, const Camera& camera);
void zoom_view(AppState& state, const Vec2& about, double factor);

// Moves the drawing so that a cursor moved by keys stays visible.
void keep_in_sight(AppState& state, const Vec2& at);

// --- Opens documents in place of the open one.

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
