#include "edits/editing.h"

#include "edits/changed_settings.h"
#include "state/notice.h"

namespace evenlift::view {

void begin_edit(AppState& state, bool live, Edit edit) {
  if (live && state.work.edit_open) return;
  state.work.history.record(state.work.document(), beside(state.work), edit);
  state.work.edit_open = live;
}

Document& edit(AppState& state, bool live, Edit edit) {
  begin_edit(state, live, edit);
  show(state, {});
  state.given = {};
  Document& document = state.work.edit();
  document.moved = {};
  return document;
}

void change_shown(AppState& state, const Shown& before, const Shown& after, bool live) {
  if (after == before) return;
  if (seen_as(after, before) != before)
    begin_edit(state, live, edit_between({{}, {}, {}, before}, {{}, {}, {}, after}));
  state.work.show() = with_changes(shown(state), before, after);
}

}  // namespace evenlift::view
