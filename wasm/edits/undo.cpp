#include "edits/undo.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "edits/sight.h"
#include "evenlift/wording.h"
#include "state/notice.h"
#include "state/seen.h"
#include "tools/handles.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Undoing a change of the picture's scale also undoes its effect on what is traced on it.
void recall_backdrop(AppState& state, const std::optional<Backdrop>& picture) {
  if (state.work.backdrop && picture && picture->picture == state.work.backdrop->picture)
    state.work.backdrop = picture;
  else if (state.work.backdrop)
    state.work.backdrop->traced = false;
}

bool is_open(const AppState& state) { return in_lesson(state) || state.view.task; }

void close_task(AppState& state) {
  state.view.task.reset();
  state.view.challenge = false;
}

void show_recalled(AppState& state, History::Recalled recalled) {
  const bool other_shape = count_handles(recalled.document) != count_handles(state.work.document());
  state.work.edit_open = false;
  show(state, {});
  state.given = {};
  state.work.edit() = std::move(recalled.document);
  if (other_shape) state.view.selected.reset();
  drop_stale_picks(state);
  const bool other_object = is_other_object(recalled.edit);
  if (other_object) state.work.aside = {};
  if (state.view.camera_follows && (other_object || !well_shown(state))) state.view.fit_due = true;
  recall_backdrop(state, recalled.beside.backdrop);
  state.work.second_method = shown(state).step ? std::nullopt : recalled.beside.second_method;
}

// `what` is announced for users who cannot see the change.
void step_back(AppState& state, History::Recalled recalled, const char* what) {
  Walkthrough& walk = state.view.walkthrough;
  Shown& former = recalled.document.shown;
  const Edit edit = recalled.edit;
  const bool leaves_lesson = is_open(state) && edit == Edit::lesson_opened;
  if (state.view.task && (leaves_lesson || state.work.history.depth() < state.view.task->depth))
    close_task(state);
  if (leaves_lesson || (walk.script && state.work.history.depth() < walk.script->depth)) {
    walk.script.reset();
    walk.aside.reset();
    walk.of_lesson = false;
  } else {
    // The step and the overlays change only when a lesson is left: then the former ones return.
    former = seen_as(former, shown(state));
  }
  // A walkthrough would show the teams at other places.
  if (!recalled.document.moved.teams.empty()) former.step.reset();
  show_recalled(state, std::move(recalled));
  announce(state, say(what, {in_words(edit)}));
}

std::optional<History::Recalled> before_lesson(AppState& state) {
  if (!is_open(state) || state.session.screen.embed) return std::nullopt;
  return state.work.history.leave_lesson(state.work.document(), beside(state.work));
}

// After an edit in the lesson, the message explains how to return to it.
void tell_of_return(AppState& state, bool edited) {
  if (edited)
    show(state, {Notice::Kind::info,
                 "Your work from before the lesson is back. Undo shows the lesson's object as you "
                 "left it."});
  else
    announce(state, "Your work from before the lesson is back.");
}

}  // namespace

void drop_stale_picks(AppState& state) {
  const Document& document = state.work.document();
  const std::size_t count = count_vertices(document);
  if (state.view.selected && *state.view.selected >= count_handles(document))
    state.view.selected.reset();
  for (Pick* pick : {&state.view.hover, &state.view.held}) {
    const bool of_polygon = pick->kind == Pick::Kind::vertex || pick->kind == Pick::Kind::edge;
    if (of_polygon && pick->index >= count) *pick = {};
    if (pick->kind == Pick::Kind::cargo && pick->index >= document.settings.cargo.size())
      *pick = {};
  }
}

void undo(AppState& state) {
  if (state.work.history.can_undo())
    step_back(state, state.work.history.undo(state.work.document(), beside(state.work)),
              "Undone: {edit}.");
}

void redo(AppState& state) {
  if (state.work.history.can_redo())
    step_back(state, state.work.history.redo(state.work.document(), beside(state.work)),
              "Redone: {edit}.");
}

void leave_walkthrough(AppState& state) {
  const std::size_t depth = state.work.history.depth();
  std::optional<History::Recalled> before = before_lesson(state);
  close_walkthrough(state);
  state.view.walkthrough.of_lesson = false;
  if (state.view.task) close_task(state);
  if (!before) return;
  // Step by step continues at the restored document's own step.
  Walkthrough& walk = state.view.walkthrough;
  walk.at = before->document.shown.step.value_or(0);
  walk.all_steps = false;
  walk.guesses = {};
  before->document.shown.step.reset();
  state.view.selected.reset();
  fit_view(state);
  show_recalled(state, *std::move(before));
  tell_of_return(state, state.work.history.depth() > depth);
}

void leave_task(AppState& state) {
  if (!state.view.task) return;
  const std::size_t depth = state.work.history.depth();
  std::optional<History::Recalled> before = before_lesson(state);
  close_task(state);
  if (!before) return;
  state.view.selected.reset();
  fit_view(state);
  show_recalled(state, *std::move(before));
  tell_of_return(state, state.work.history.depth() > depth);
}

void leave_lesson_for_another(AppState& state) {
  std::optional<History::Recalled> before = before_lesson(state);
  if (state.view.task) close_task(state);
  if (!before) return;
  state.work.edit() = std::move(before->document);
  state.work.second_method = before->beside.second_method;
  recall_backdrop(state, before->beside.backdrop);
}

}  // namespace evenlift::view
