#include "actions/key_list.h"

#include <cstddef>

#include "actions/actions.h"
#include "actions/when.h"

namespace evenlift::view {
namespace {

// In the order of the window (web/windows/keys.js).
enum Group { files, editing, teams, view, lesson, help };
Group group_of(ActionId id) {
  switch (id) {
    case ActionId::samples:
    case ActionId::open:
    case ActionId::save:
    case ActionId::copy_link:
      return files;
    case ActionId::draw:
    case ActionId::transform:
    case ActionId::mark:
    case ActionId::table:
    case ActionId::undo:
    case ActionId::redo:
    case ActionId::finish:
    case ActionId::place:
    case ActionId::take_back:
    case ActionId::type_edge:
    case ActionId::left_finely:
    case ActionId::right_finely:
    case ActionId::up_finely:
    case ActionId::down_finely:
    case ActionId::next_vertex:
    case ActionId::previous_vertex:
    case ActionId::insert_vertex:
    case ActionId::remove_vertex:
    case ActionId::left:
    case ActionId::right:
    case ActionId::up:
    case ActionId::down:
    case ActionId::turn_left:
    case ActionId::turn_right:
    case ActionId::larger:
    case ActionId::smaller:
    case ActionId::snap_grid:
    case ActionId::snap_axis:
      return editing;
    case ActionId::more_teams:
    case ActionId::fewer_teams:
    case ActionId::next_method:
    case ActionId::compare:
    case ActionId::experiment:
    case ActionId::higher_ratio:
    case ActionId::lower_ratio:
    case ActionId::all_teams:
    case ActionId::fail:
    case ActionId::type_ratio:
    case ActionId::type_weight:
    case ActionId::type_capacity:
    case ActionId::type_doubt:
    case ActionId::type_robot:
    case ActionId::type_seed:
    case ActionId::type_centre:
    case ActionId::free_centre:
      return teams;
    case ActionId::toggle_hull:
    case ActionId::toggle_clockwise:
    case ActionId::toggle_counterclockwise:
    case ActionId::toggle_chords:
    case ActionId::toggle_candidates:
    case ActionId::toggle_tipping:
    case ActionId::toggle_halo:
    case ActionId::zoom_in:
    case ActionId::zoom_out:
    case ActionId::fit:
    case ActionId::fold_panel:
    case ActionId::motion:
      return view;
    case ActionId::lessons:
    case ActionId::walkthrough:
    case ActionId::step_on:
    case ActionId::step_back:
    case ActionId::next_chapter:
    case ActionId::previous_chapter:
    case ActionId::first_step:
    case ActionId::last_step:
    case ActionId::play:
    case ActionId::faster:
    case ActionId::slower:
    case ActionId::predict:
    case ActionId::all_steps:
    case ActionId::present:
      return lesson;
    case ActionId::help:
    case ActionId::about:
    case ActionId::glossary:
    case ActionId::welcome:
    case ActionId::dismiss:
      break;
  }
  return help;
}

}  // namespace

std::string key_list(bool embed) {
  std::string text;
  for (const Group group : {files, editing, teams, view, lesson, help}) {
    if (embed && group < view) continue;
    for (const Action& a : actions()) {
      if (*a.shown && group_of(a.id) == group && !(embed && a.enabled == when::editing))
        text += std::to_string(group) + '\t' + a.shown + '\t' + a.label + '\n';
    }
  }
  return text;
}

}  // namespace evenlift::view
