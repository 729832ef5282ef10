// The one table of actions, which the toolbar, the keyboard and the list of keys use.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "state/command.h"
#include "state/state.h"
#include "ui/icons.h"

namespace evenlift::view {

// clang-format off
enum class ActionId : std::uint8_t {
  samples, draw, lessons, walkthrough, transform, mark, open, save, table, undo, redo, copy_link,
  step_on, step_back, next_chapter, previous_chapter, first_step, last_step, play, faster, slower, predict, all_steps, present,
  finish, place, take_back, type_edge, next_vertex, previous_vertex, insert_vertex, remove_vertex,
  left_finely, right_finely, up_finely, down_finely, left, right, up, down, turn_left, turn_right, larger, smaller, snap_grid, snap_axis,
  more_teams, fewer_teams, place_yourself, add_robots, remove_robot, even_out, weigh, take_over, next_method, balanced, compare, experiment, higher_ratio, lower_ratio,
  all_teams, fail, type_ratio, type_weight, type_capacity, type_uncertainty, type_robot, type_seed, type_centre, free_centre,
  toggle_hull, toggle_clockwise, toggle_counterclockwise, toggle_chords, toggle_candidates, toggle_tipping, toggle_halo, toggle_tilt, toggle_load,
  zoom_in, zoom_out, fit, fold_panel, motion, explain, help, about, glossary, welcome, language, dismiss
};
// clang-format on

// The headings in the list of keys, in the order of the window (web/windows/keys.js).
enum class Group : std::uint8_t { files, editing, teams, view, lesson, help };

// A key as KeyboardEvent.key names it; `command` is Ctrl, or Cmd on a Mac.
struct Key {
  std::string_view name;
  bool command = false;
  bool shift = false;  // ignored unless the table sets it or `command` is set
};

struct Action {
  ActionId id;
  Group group;
  Icon icon;
  const char* label;
  const char* shown;  // its key in words; "" if it has no key
  Key keys[12];       // each of these runs the action
  bool (*enabled)(const AppState&);
  void (*run)(const AppState&, Commands&);
};

const std::vector<Action>& actions();
const Action& action(ActionId id);

// The action's present effect in words, with its key: "Undo: moved a vertex (Ctrl+Z)".
std::string tip(const Action& action, const AppState& state);

// Returns the enabled action of a key. If it returns null, the browser handles the key.
const Action* action_for(const AppState& state, const Key& key);

// The actions with a key, by group. With `embed`, only the actions that work in an <iframe>.
std::vector<const Action*> key_list(bool embed);

}  // namespace evenlift::view

namespace evenlift::view::when {

// --- Conditions under which actions are possible.

bool always(const AppState& s);
bool editing(const AppState& s);  // not in an <iframe>

// About the present tool or selection.
bool drawing(const AppState& s);
bool transforming(const AppState& s);
bool in_walkthrough(const AppState& s);
bool on_parts(const AppState& s);
bool on_vertex(const AppState& s);  // a vertex or a weight is selected
bool on_ring(const AppState& s);    // a vertex of the outline or of a hole is selected
bool on_robot(const AppState& s);   // the card of a movable robot is open
bool can_change_method(const AppState& s);
bool by_own_hand(const AppState& s);   // the robots are placed by hand
bool can_weigh(const AppState& s);     // no challenge or task is open
bool is_weighed(const AppState& s);    // the robots have readings, which give the weight and C
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

bool has_marks(const AppState& s);      // the picture has marks that explain themselves
bool anything_open(const AppState& s);  // Escape would close something

}  // namespace evenlift::view::when
