#include "edits/open_document.h"

#include <utility>

#include "edits/editing.h"
#include "edits/sight.h"
#include "state/notice.h"

namespace evenlift::view {
namespace {

void forget_former(AppState& state) {
  if (draws(state.view.tool)) state.view.tool = Tool::parts;
  state.view.drawing = {};
  state.view.selected.reset();
  state.work.aside = {};
  if (state.work.backdrop) state.work.backdrop->traced = false;
  state.view.hover = state.view.held = {};
  if (state.view.task) state.view.challenge = false;
  state.view.task.reset();
  // A new walkthrough begins at the document's step, if any.
  state.view.walkthrough.trace.reset();
  state.view.walkthrough.script.reset();
  state.view.walkthrough.aside.reset();
  state.view.walkthrough.of_lesson = false;
  state.view.walkthrough.playing = false;
  state.view.walkthrough.visited.clear();
  state.view.walkthrough.guesses = {};
  state.view.walkthrough.at = 0;
  state.view.walkthrough.all_steps = false;
  fit_view(state);
}

}  // namespace

void show_opened(AppState& state, Opened opened) {
  forget_former(state);
  show(state, {});
  state.work.edit() = std::move(opened.document);
  state.given = {std::move(opened.placement), std::move(opened.trace), {}, {}};
}

void open(AppState& state, Opened opened, Edit edit) {
  begin_edit(state, false, edit);
  ++state.session.opened;
  if (edit == Edit::lesson_opened)
    state.work.second_method.reset();  // a lesson uses the whole picture
  show_opened(state, std::move(opened));
}

void start_with(AppState& state, Opened opened, const std::optional<Document>& work) {
  if (work) {
    state.work.edit() = *work;
    open(state, std::move(opened));
  } else {
    show_opened(state, std::move(opened));
  }
}

void resume_draft(AppState& state, Document draft) {
  Document& document = edit(state, false, Edit::vertex_moved);
  forget_former(state);
  document = std::move(draft);
  document.moved = {};
}

}  // namespace evenlift::view
