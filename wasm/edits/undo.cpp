#include "edits/undo.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "edits/placing.h"
#include "edits/sight.h"
#include "state/browser.h"
#include "state/notice.h"
#include "state/opened.h"
#include "state/seen.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// A change of the picture's scale is undone with what was traced on it.
void recall_backdrop(AppState& state, const std::optional<Backdrop>& picture) {
  if (state.backdrop && picture && picture->picture == state.backdrop->picture)
    state.backdrop = picture;
  else if (state.backdrop)
    state.backdrop->traced = false;
}

// Shows a document of the history in place of the one that is open.
void show_recalled(AppState& state, History::Recalled recalled) {
  const bool other_shape = recalled.document.vertices.size() != state.document.vertices.size();
  state.edit_open = false;
  state.document = std::move(recalled.document);
  if (other_shape) state.selected.reset();
  drop_stale_picks(state);
  const bool other_object = is_other_object(recalled.edit);
  if (other_object) state.aside = {};
  if (state.camera_follows && (other_object || !well_shown(state))) state.fit_due = true;
  recall_backdrop(state, recalled.beside.backdrop);
  state.second_method.reset();  // so that the two methods are not exchanged
  adopt(state, compute_placement(state.document, state.placement));
  if (!shown(state).step) state.second_method = recalled.beside.second_method;
  follow_up(state);
  follow_placement(state);
}

// Undo and redo. Those who cannot see what changed are told.
void step_back(AppState& state, History::Recalled recalled, const char* what) {
  Walkthrough& walk = state.walkthrough;
  Shown& former = recalled.document.shown;
  const Edit edit = recalled.edit;
  const bool leaves_lesson = in_lesson(state) && edit == Edit::lesson_opened;
  if (leaves_lesson || (walk.script && state.history.depth() < walk.script->depth)) {
    walk.script.reset();
    walk.aside.reset();
    walk.of_lesson = false;
  } else {
    // Neither the step of the walkthrough nor the overlays are undone, unless that leaves a lesson: then the
    // former ones come back.
    former = seen_as(former, shown(state));
  }
  // A lesson would show teams elsewhere.
  if (!recalled.document.moved.teams.empty()) former.step.reset();
  show_recalled(state, std::move(recalled));
  if (!state.refusal) browser::announce(what + in_words(edit) + ".");
}

// What was open before the lesson, if one is open.
std::optional<History::Recalled> before_lesson(AppState& state) {
  if (!in_lesson(state) || state.screen.embed) return std::nullopt;
  return state.history.leave_lesson(state.document, beside(state));
}

// Says that what was open before the lesson is back. Who edited something in the lesson reads how that comes back.
void tell_of_return(AppState& state, bool edited) {
  if (state.refusal) return;  // that is told already
  const std::string back = "What was open before the lesson is back.";
  if (edited)
    show(state, {Notice::Kind::info, back + " Undo shows the lesson's object as you left it."});
  else
    browser::announce(back);
}

}  // namespace

void drop_stale_picks(AppState& state) {
  const std::size_t count = state.document.vertices.size();
  if (state.selected && *state.selected >= count) state.selected.reset();
  for (Pick* pick : {&state.hover, &state.held}) {
    const bool of_polygon = pick->kind == Pick::Kind::vertex || pick->kind == Pick::Kind::edge;
    if (of_polygon && pick->index >= count) *pick = {};
  }
}

void undo(AppState& state) {
  if (state.history.can_undo())
    step_back(state, state.history.undo(state.document, beside(state)), "Undone: ");
}

void redo(AppState& state) {
  if (state.history.can_redo())
    step_back(state, state.history.redo(state.document, beside(state)), "Done again: ");
}

void leave_walkthrough(AppState& state) {
  const std::size_t depth = state.history.depth();
  std::optional<History::Recalled> before = before_lesson(state);
  close_walkthrough(state);
  state.walkthrough.of_lesson = false;
  if (!before) return;
  // Step by step begins where it was left on what is open now.
  Walkthrough& walk = state.walkthrough;
  walk.at = before->document.shown.step.value_or(0);
  walk.all_steps = false;
  walk.guesses = {};
  before->document.shown.step.reset();
  state.selected.reset();
  fit_view(state);
  show_recalled(state, *std::move(before));
  tell_of_return(state, state.history.depth() > depth);
}

void leave_lesson_for_another(AppState& state) {
  std::optional<History::Recalled> before = before_lesson(state);
  if (!before) return;
  state.document = std::move(before->document);
  state.second_method = before->beside.second_method;
  recall_backdrop(state, before->beside.backdrop);
}

}  // namespace evenlift::view
