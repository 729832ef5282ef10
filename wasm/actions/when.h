// Conditions under which actions are possible.
#pragma once

#include "state/state.h"

namespace evenlift::view::when {

bool always(const AppState& s);
bool editing(const AppState& s);  // not in an <iframe>

// About the present tool or selection.
bool drawing(const AppState& s);
bool transforming(const AppState& s);
bool in_walkthrough(const AppState& s);
bool on_parts(const AppState& s);
bool on_vertex(const AppState& s);     // a vertex or a weight is selected
bool on_ring(const AppState& s);       // a vertex of the outline or of a hole is selected
bool on_robot(const AppState& s);      // the card of a movable robot is open
bool by_own_hand(const AppState& s);   // the robots are placed by hand
bool can_even_out(const AppState& s);  // the robots are placed by hand, but not in a challenge
bool on_own_robot(const AppState& s);  // the robots are placed by hand, and the card of one is open
bool can_nudge(const AppState& s);

// While a polygon is being drawn, undo removes one vertex.
bool has_no_cursor(const AppState& s);  // nothing is drawn, and the cursor has no place yet
bool keys_place(const AppState& s);     // keys moved the cursor to a place where a vertex can go
bool can_place(const AppState& s);
bool can_finish(const AppState& s);
bool can_take_back(const AppState& s);
bool can_undo(const AppState& s);
bool can_redo(const AppState& s);

// About the walkthrough.
bool can_teach(const AppState& s);
bool can_go_on(const AppState& s);
bool can_go_back(const AppState& s);

// About settings.
bool has_teams_number(const AppState& s);
bool by_candidates(const AppState& s);
bool is_random(const AppState& s);
bool has_own_centre(const AppState& s);
bool has_height(const AppState& s);  // C has a height
bool has_extra(const AppState& s);   // the user asks about a further load
bool can_fail(const AppState& s);

bool anything_open(const AppState& s);  // Escape would close something

}  // namespace evenlift::view::when
