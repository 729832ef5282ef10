// Edits as a whole and their undo, opening documents, and what is in sight.
#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "state/derived.h"
#include "state/state.h"
#include "state/work.h"

namespace evenlift::view {

// --- The visible part of the plane.

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

// Whether the settings agree in all values on which the robots' places depend. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The kind of edit to which the differing setting belongs; Edit::settings if the differing settings
// belong to several kinds, or if none differs. The documents must have the same vertices. O(bytes).
Edit edit_between(const Document& before, const Document& after);

// Returns `shown` with those values of `after` that differ from `before`, except the step.
// O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

// The edited document with what readings told, if the present document has readings that no longer
// apply after this edit (settled_after_edit() of weighing.h); otherwise nothing. O(document).
std::optional<Document> without_stale_readings(const AppState& state, const Document& edited);

// --- Edits by scripts and in the table of vertices. Each edit is accepted or refused as a whole.

// Takes over an edited document as one step of undo, or returns why it is refused and changes
// nothing. There is no step of undo if only the walkthrough's step or overlays differ, and nothing
// is placed if only shown values differ. The document is also refused if its placement has no robot
// with the number `failed`, from 1; 0 stands for no robot.
std::optional<InputError> try_edit(AppState& state, const Document& edited,
                                   std::uint64_t failed = 0);

// --- Undo, redo, and the return from a lesson to the work before it.

void undo(AppState& state);
void redo(AppState& state);

// Leaves the walkthrough. If it belongs to a lesson, restores the document that was open before the
// lesson, with its settings and steps of undo. After an edit in the lesson, leaving the lesson is
// itself a step of undo, and a notice says so. In an <iframe> the lesson's object stays, since
// nothing was open before.
void leave_walkthrough(AppState& state);

// Leaves the task of a lesson in the same way, if a task is open.
void leave_task(AppState& state);

// Leaves a lesson because another one opens at once, so nothing is placed or shown.
void leave_lesson_for_another(AppState& state);

// Forgets a selected, hovered or held vertex, edge or weight that no longer exists. O(1).
void drop_stale_picks(AppState& state);

// --- Begins edits. Their consequences are derived after all commands.

// Records the work for undo. Consecutive live edits, such as those of a drag, are one step.
void begin_edit(AppState& state, bool live, Edit edit);

// Begins an edit, and returns the document to change, which will be placed again. The last notice
// ends, and robots moved by hand go back.
Document& edit(AppState& state, bool live, Edit edit);

// Changes the shown values that differ between `before` and `after`, except the step. The change is
// an edit, unless only overlays differ.
void change_shown(AppState& state, const Shown& before, const Shown& after, bool live = false);

}  // namespace evenlift::view
