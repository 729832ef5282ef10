#include "edits/changed_settings.h"

namespace evenlift::view {
namespace {

// Whether balanced robots are to hold as firmly.
bool same_margin(const Settings& a, const Settings& b) {
  return a.min_margin == b.min_margin && a.apart == b.apart && a.clear == b.clear &&
         a.survive == b.survive;
}

}  // namespace

Settings placing_as(Settings settings, const Settings& other) {
  settings.step = other.step;
  settings.capacity = other.capacity;
  settings.com_radius = other.com_radius;
  settings.units = other.units;
  return settings;
}

bool stand_alike(const Settings& a, const Settings& b) {
  Settings but = placing_as(a, b);
  but.weight = b.weight;
  but.overlays = b.overlays;
  return but == b;
}

Edit edit_between(const Settings& before, const Settings& after) {
  Edit edit = Edit::settings;
  int differing = 0;
  const auto compare = [&](bool same, Edit which) {
    if (same) return;
    edit = which;
    ++differing;
  };
  compare(before.teams == after.teams, Edit::teams);
  compare(before.method == after.method, Edit::method);
  compare(before.min_ratio == after.min_ratio, Edit::min_ratio);
  compare(before.weight == after.weight, Edit::weight);
  compare(before.seed == after.seed, Edit::seed);
  compare(before.robots == after.robots, Edit::robots);
  compare(before.goal == after.goal && same_margin(before, after), Edit::goal);
  compare(before.positions == after.positions, Edit::positions);
  compare(before.capacity == after.capacity, Edit::capacity);
  compare(before.com_radius == after.com_radius, Edit::com_radius);
  compare(before.robot == after.robot, Edit::robot_size);
  compare(before.no_go == after.no_go, Edit::marks);
  return differing == 1 ? edit : Edit::settings;
}

Edit edit_between(const Document& before, const Document& after) {
  if (before.centre_of_mass == after.centre_of_mass)
    return edit_between(before.settings, after.settings);
  Settings but_step = after.settings;
  but_step.step = before.settings.step;
  if (but_step != before.settings) return Edit::settings;
  return after.centre_of_mass ? Edit::centre_moved : Edit::centre_released;
}

}  // namespace evenlift::view
