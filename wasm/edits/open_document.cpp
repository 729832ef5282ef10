#include "edits/open_document.h"

#include <utility>

#include "edits/placing.h"
#include "edits/sight.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view {
namespace {

// Forgets what belonged to the former document.
void forget_former(AppState& state) {
  if (state.tool == Tool::draw) state.tool = Tool::parts;
  state.drawing = {};
  state.selected.reset();
  state.aside = {};
  if (state.backdrop) state.backdrop->traced = false;
  state.hover = state.held = {};
  // The walkthrough begins with the document's step, if it has one.
  state.walkthrough.trace.reset();
  state.walkthrough.script.reset();
  state.walkthrough.aside.reset();
  state.walkthrough.of_lesson = false;
  state.walkthrough.playing = false;
  state.walkthrough.visited.clear();
  state.walkthrough.guesses = {};
  state.walkthrough.at = 0;
  state.walkthrough.all_steps = false;
  fit_view(state);
}

}  // namespace

void show_opened(AppState& state, Opened opened) {
  forget_former(state);
  state.document = std::move(opened.document);
  adopt(state, std::move(opened.placement));
  follow_up(state);
  follow_placement(state, std::move(opened.trace));
}

void open(AppState& state, Opened opened, Edit edit) {
  begin_edit(state, false, edit);
  ++state.opened;
  if (edit == Edit::lesson_opened) state.second_method.reset();  // a lesson has the whole picture
  show_opened(state, std::move(opened));
}

void start_with(AppState& state, Opened opened, const std::optional<Document>& work) {
  if (work) {
    state.document = *work;
    open(state, std::move(opened));
  } else {
    show_opened(state, std::move(opened));
  }
}

void resume_draft(AppState& state, Document draft) {
  begin_edit(state, false, Edit::vertex_moved);
  forget_former(state);
  state.document = std::move(draft);
  recompute(state);
}

}  // namespace evenlift::view
