// Changes the settings when the method changes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "state/state.h"

namespace evenlift::view {

// Returns the number of placed teams, but at least 1, and 3 if nothing is placed. If the robots are
// not in teams, every two robots count as a team.
inline std::uint32_t placed_teams(const std::optional<Placement>& placement) {
  if (!placement) return 3;
  return std::max<std::uint32_t>(1, static_cast<std::uint32_t>(count_robots(placement->teams) / 2));
}
inline std::uint32_t placed_teams(const AppState& state) {
  return placed_teams(state.derived().placement);
}

// Returns whether the method considers the robots' size. For the other methods, robots are points.
inline bool takes_sizes(Method method) { return is_one_team(method) || selects_candidates(method); }

// Returns the settings with another method. If the method does not support "max" teams, `teams`
// replaces "max". Supports, goal, robots' size and no-go edges are reset unless the method supports
// them. The goal is also reset if the method changes from balanced robots to teams.
inline Settings with_method(Settings settings, Method method, std::uint32_t teams) {
  const bool balanced = method == Method::balanced;
  if (method != Method::given) {
    settings.supports.clear();
    settings.support_names.clear();
  }
  if (!settings.teams && !selects_candidates(method) && !balanced) settings.teams = teams;
  const bool from_balanced = settings.method == Method::balanced;
  if (!balanced && (from_balanced || !selects_candidates(method))) settings.goal.reset();
  if (!takes_sizes(method)) {
    settings.robot = {};
    settings.no_go.clear();
  }
  settings.method = method;
  return settings;
}

// Changes the method. If the new method does not support the robots' size, the no-go edges or the
// goal of teams, `aside` keeps them until the user chooses a method that supports them. The goal
// of balanced robots is not kept.
struct WithMethod {
  Settings settings;
  SetAside aside;
};
inline WithMethod with_method(const Settings& now, Method method, std::uint32_t teams,
                              SetAside aside) {
  Settings settings = with_method(now, method, teams);
  const bool had_sizes = takes_sizes(now.method), had_goal = selects_candidates(now.method);
  if (had_sizes) {
    aside.robot = now.robot;
    aside.no_go = now.no_go;
  } else if (takes_sizes(method)) {
    settings.robot = aside.robot.value_or(settings.robot);
    settings.no_go = aside.no_go.value_or(settings.no_go);
  }
  if (had_goal)
    aside.goal = now.goal;
  else if (selects_candidates(method) && aside.goal)
    settings.goal = aside.goal;
  return {std::move(settings), std::move(aside)};
}

// Returns the smallest number of robots that the settings allow.
inline std::uint32_t fewest_robots(const Settings& settings) {
  return settings.survive == 0 ? least_robots : 2 * settings.survive + 3;
}

}  // namespace evenlift::view
