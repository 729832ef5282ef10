#include "edits/by_hand.h"

#include <utility>

#include "edits/editing.h"
#include "evenlift/moved.h"
#include "evenlift/plane.h"
#include "evenlift/stands.h"
#include "state/notice.h"
#include "tools/shorter_way.h"

namespace evenlift::view {
namespace {

LiftingPoint nearest_on_outline(const Points& vertices, const Vec2& to) {
  LiftingPoint nearest{vertices[0], 0};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], to);
    if (length(at - to) < length(nearest.position - to))
      nearest = {at, static_cast<std::uint32_t>(i)};
  }
  return nearest;
}

// A team's left end has the lower number, so the held robot's may change.
void follow_grip(AppState& state, const Placement& placement, std::size_t now) {
  const auto [team, robot] = find_robot(placement.teams, now);
  if (state.view.held.kind == Pick::Kind::robot && state.view.held.index == team)
    state.view.held.end = static_cast<int>(robot);
}

// The number of the team's robot on the edge of `team.end`.
std::size_t number_of(const Placement& placement, const MovedTeam& team) {
  const std::vector<Robot>& robots = placement.teams[team.team].robots;
  return team.team * robots.size() + (robots[0].point.edge == team.end.edge ? 0 : 1);
}

const MovedTeam* find_team(const Moved& moved, std::size_t team) {
  for (const MovedTeam& each : moved.teams)
    if (each.team == team) return &each;
  return nullptr;
}

// Notes that the held robot cannot go there; for keys, shows a notice. O(n).
void refuse_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  if (state.view.held.kind == Pick::Kind::robot)
    state.view.closed_to = nearest_on_outline(state.derived().placement->vertices(), to);
  else
    show(state, {Notice::Kind::info, closed_in_words(*state.derived().placement, robot)});
}

// The robots after a move by move_robot(); nothing if they stay. O(n log n).
std::optional<Moved> moved_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  state.view.closed_to.reset();
  if (state.derived().refusal || !state.derived().placement ||
      state.derived().placement->teams.empty())
    return std::nullopt;
  const Placement& placement = *state.derived().placement;
  if (can_move_teams(placement)) return moved_along_range(placement, robot, to);
  if (placement.settings.method != Method::balanced) return std::nullopt;
  auto moved = moved_along_outline(placement, robot, nearest_on_outline(placement.vertices(), to));
  if (!moved) refuse_by_hand(state, robot, to);
  return moved;
}

std::size_t number_after(const Placement& placement, std::size_t robot) {
  const MovedTeam* moved = find_team(placement.moved, find_robot(placement.teams, robot).team);
  return moved ? number_of(placement, *moved) : robot;
}

}  // namespace

void move_robot(AppState& state, std::size_t robot, const Vec2& to) {
  const std::optional<Moved> moved = moved_by_hand(state, robot, to);
  if (!moved || *moved == state.work.document().moved) return;
  Result<Placement> placement = with_moved(*state.derived().placement, *moved);
  if (!placement) return refuse_by_hand(state, robot, to);  // two robots would meet
  begin_edit(state, true, Edit::robots_moved);
  state.work.edit().moved = placement->moved;
  const std::size_t now = number_after(*placement, robot);
  if (now != robot) follow_grip(state, *placement, now);
  state.given = {};
  state.given.placement = std::move(placement).value();
  state.given.moved = {robot, now};
}

void put_robots_back(AppState& state) {
  if (state.work.document().moved.any()) edit(state, false, Edit::robots_reset);
}

void put_teams_back(AppState& state) {
  if (!state.work.document().moved.teams.empty()) put_robots_back(state);
}

}  // namespace evenlift::view
