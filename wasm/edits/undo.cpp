#include "edits/undo.h"

#include <string>
#include <utility>

#include "edits/placing.h"
#include "state/browser.h"
#include "state/opened.h"
#include "state/seen.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Undo and redo. Those who cannot see what changed are told.
void step_back(AppState& state, History::Recalled recalled, const char* what) {
  Document& document = recalled.document;
  const bool other_shape = document.vertices.size() != state.document.vertices.size();
  state.edit_open = false;
  // The step of the walkthrough is not undone, except when undo leaves a script: then the former
  // step comes back.
  if (state.walkthrough.script && state.history.depth() < state.walkthrough.script->depth)
    state.walkthrough.script.reset();
  else
    document.settings.step = state.document.settings.step;
  document.settings.overlays = state.document.settings.overlays;  // neither are the overlays
  // A lesson would show teams elsewhere.
  if (!document.moved.teams.empty()) document.settings.step.reset();
  state.document = std::move(document);
  if (other_shape) state.selected.reset();
  drop_stale_picks(state);
  const bool other_object = recalled.edit == Edit::opened || recalled.edit == Edit::drawn;
  if (other_object) state.aside = {};
  if (state.camera_follows && (other_object || !well_shown(state))) state.fit_due = true;
  // A change of the picture's scale is undone with what was traced on it.
  const std::optional<Backdrop>& picture = recalled.beside.backdrop;
  if (state.backdrop && picture && picture->picture == state.backdrop->picture)
    state.backdrop = picture;
  else if (state.backdrop)
    state.backdrop->traced = false;
  state.second_method.reset();  // so that the two methods are not exchanged
  adopt(state, compute_placement(state.document, state.placement));
  if (!walkthrough_is_open(state)) state.second_method = recalled.beside.second_method;
  follow_up(state);
  follow_placement(state);
  if (!state.refusal) browser::announce(what + std::string(in_words(recalled.edit)) + ".");
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

}  // namespace evenlift::view
