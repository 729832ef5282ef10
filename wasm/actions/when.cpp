#include "actions/when.h"

#include "evenlift/moved.h"
#include "tools/drawing.h"
#include "walkthrough/timeline.h"

namespace evenlift::view::when {

bool always(const AppState&) { return true; }

bool editing(const AppState& s) { return !s.screen.embed; }

bool drawing(const AppState& s) { return s.tool == Tool::draw; }

bool in_walkthrough(const AppState& s) { return walkthrough_is_open(s); }

bool transforming(const AppState& s) { return editing(s) && s.tool == Tool::transform; }

bool on_parts(const AppState& s) { return editing(s) && s.tool == Tool::parts; }

bool on_vertex(const AppState& s) { return on_parts(s) && s.selected.has_value(); }

bool on_robot(const AppState& s) {
  return on_parts(s) && s.explanation && s.explanation->robot && s.placement &&
         (settings(s).method == Method::balanced || can_move_teams(*s.placement));
}

bool can_nudge(const AppState& s) {
  return on_vertex(s) || on_robot(s) || transforming(s) || drawing(s);
}

bool keys_place(const AppState& s) {
  const Drawing& d = s.drawing;
  return d.by_keys && d.cursor && (d.points.empty() || *d.cursor != d.points.back()) &&
         !closes(s, s.camera.to_screen(*d.cursor));
}

bool has_no_cursor(const AppState& s) { return !s.drawing.cursor && s.drawing.points.empty(); }

bool can_place(const AppState& s) {
  return drawing(s) && (s.drawing.cursor.has_value() || has_no_cursor(s));
}

bool can_finish(const AppState& s) {
  return drawing(s) && (keys_place(s) || s.drawing.points.size() >= 3 || has_no_cursor(s));
}

bool can_take_back(const AppState& s) { return drawing(s) && !s.drawing.points.empty(); }

bool can_undo(const AppState& s) {
  return drawing(s) ? !s.drawing.points.empty() : s.history.can_undo();
}

bool can_redo(const AppState& s) {
  return drawing(s) ? !s.drawing.undone.empty() : s.history.can_redo();
}

bool can_teach(const AppState& s) { return s.placement && !s.refusal && s.tool != Tool::draw; }

bool can_present(const AppState& s) { return editing(s) && (in_walkthrough(s) || can_teach(s)); }

bool can_go_on(const AppState& s) {
  const Timeline t = timeline(s);
  return in_walkthrough(s) && (t.at + 1 < t.count || s.walkthrough.ask);
}

bool can_go_back(const AppState& s) { return in_walkthrough(s) && timeline(s).at > 0; }

bool has_teams_number(const AppState& s) { return editing(s) && s.placement.has_value(); }

bool by_candidates(const AppState& s) {
  return has_teams_number(s) && selects_candidates(settings(s).method);
}

bool is_random(const AppState& s) { return editing(s) && settings(s).method == Method::random; }

bool has_own_centre(const AppState& s) {
  return editing(s) && s.document.centre_of_mass.has_value();
}

bool can_fail(const AppState& s) {
  return on_parts(s) && s.placement && !s.placement->teams.empty() && !s.refusal &&
         !in_walkthrough(s);
}

bool anything_open(const AppState& s) {
  return s.list_open || s.explanation || failing(s) || s.selected || s.tool != Tool::parts ||
         !s.notice.text.empty() ||
         (in_walkthrough(s) && (editing(s) || !s.walkthrough.why.empty()));
}

}  // namespace evenlift::view::when
