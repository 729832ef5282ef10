#pragma once

#include <cstdint>
#include <optional>

#include "evenlift/document.h"
#include "evenlift/result.h"
#include "state/history.h"
#include "state/state.h"

namespace evenlift::view {

// Whether the settings agree in all values on which the robots' places depend. O(bytes).
bool stand_alike(const Settings& a, const Settings& b);

// The kind of edit to which the differing setting belongs; Edit::settings if the differing settings
// belong to several kinds, or if none differs. The documents must have the same vertices. O(bytes).
Edit edit_between(const Document& before, const Document& after);

// Returns `shown` with those values of `after` that differ from `before`, except the step.
// O(bytes).
Shown with_changes(const Shown& shown, const Shown& before, const Shown& after);

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
