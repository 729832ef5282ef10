#include "actions/actions.h"

#include "evenlift/moved.h"
#include "tools/drawing.h"
#include "tools/pick.h"
#include "tools/picture_marks.h"
#include "walkthrough/walkthrough.h"

namespace evenlift::view::when {

bool always(const AppState&) { return true; }

bool editing(const AppState& s) { return !s.session.screen.embed; }

bool drawing(const AppState& s) { return draws(s.view.tool); }

bool in_walkthrough(const AppState& s) { return walkthrough_is_open(s); }

bool transforming(const AppState& s) { return editing(s) && s.view.tool == Tool::transform; }

bool on_parts(const AppState& s) {
  return editing(s) && (s.view.tool == Tool::parts || s.view.tool == Tool::weight);
}

bool on_vertex(const AppState& s) { return on_parts(s) && s.view.selected.has_value(); }

bool on_ring(const AppState& s) {
  return on_vertex(s) && *s.view.selected < count_vertices(s.work.document());
}

bool on_robot(const AppState& s) {
  return on_parts(s) && s.derived().explanation && s.derived().explanation->robot &&
         s.derived().placement && !in_walkthrough(s);
}

bool by_own_hand(const AppState& s) {
  return has_teams_number(s) && settings(s).method == Method::given;
}

bool can_change_method(const AppState& s) { return editing(s) && !stays_by_hand(s); }

bool can_weigh(const AppState& s) {
  return has_teams_number(s) && !s.view.challenge && !s.view.task;
}

bool is_weighed(const AppState& s) {
  return editing(s) && s.derived().placement && s.derived().placement->weighing;
}

bool can_even_out(const AppState& s) { return by_own_hand(s) && !s.view.challenge; }

bool on_own_robot(const AppState& s) { return on_robot(s) && by_own_hand(s); }

bool can_nudge(const AppState& s) {
  return on_vertex(s) || on_robot(s) || transforming(s) || drawing(s);
}

bool keys_place(const AppState& s) {
  const Drawing& d = s.view.drawing;
  return d.by_keys && d.cursor && (d.points.empty() || *d.cursor != d.points.back()) &&
         !closes(s, s.view.camera.to_screen(*d.cursor));
}

bool has_no_cursor(const AppState& s) {
  return !s.view.drawing.cursor && s.view.drawing.points.empty();
}

bool can_place(const AppState& s) {
  return drawing(s) && (s.view.drawing.cursor.has_value() || has_no_cursor(s));
}

bool can_finish(const AppState& s) {
  return drawing(s) && (keys_place(s) || s.view.drawing.points.size() >= 3 || has_no_cursor(s));
}

bool can_take_back(const AppState& s) { return drawing(s) && !s.view.drawing.points.empty(); }

bool can_undo(const AppState& s) {
  if (can_go_on_drawing(s)) return true;
  return drawing(s) ? !s.view.drawing.points.empty() : s.work.history.can_undo();
}

bool can_redo(const AppState& s) {
  return drawing(s) ? !s.view.drawing.undone.empty() : s.work.history.can_redo();
}

bool can_teach(const AppState& s) {
  return s.derived().placement && !s.derived().refusal && !draws(s.view.tool);
}

bool can_go_on(const AppState& s) {
  const Timeline t = timeline(s);
  return in_walkthrough(s) && (t.at + 1 < t.count || s.view.walkthrough.ask);
}

bool can_go_back(const AppState& s) { return in_walkthrough(s) && timeline(s).at > 0; }

bool has_teams_number(const AppState& s) { return editing(s) && s.derived().placement.has_value(); }

bool by_candidates(const AppState& s) {
  return has_teams_number(s) && selects_candidates(settings(s).method);
}

bool is_random(const AppState& s) { return editing(s) && settings(s).method == Method::random; }

bool has_own_centre(const AppState& s) {
  return editing(s) && s.work.document().centre_of_mass.has_value();
}

bool has_height(const AppState& s) { return shown(s).carrying.has_height(); }

bool has_extra(const AppState& s) { return shown(s).carrying.extra.has_value(); }

bool can_fail(const AppState& s) {
  return on_parts(s) && s.derived().placement && !s.derived().placement->teams.empty() &&
         !s.derived().refusal && !in_walkthrough(s);
}

bool has_marks(const AppState& s) {
  return s.view.tool == Tool::parts && !in_walkthrough(s) && s.derived().placement;
}

bool anything_open(const AppState& s) {
  return s.session.list_open || explained_mark(s) || s.derived().explanation || failing(s) ||
         s.view.selected || s.view.tool != Tool::parts || !s.session.notice.text.empty() ||
         s.view.presenting ||
         (in_walkthrough(s) && (editing(s) || !s.view.walkthrough.why.empty()));
}

}  // namespace evenlift::view::when
