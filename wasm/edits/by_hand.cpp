#include "edits/by_hand.h"

#include <utility>

#include "edits/outlook.h"
#include "edits/placing.h"
#include "edits/search.h"
#include "evenlift/moved.h"
#include "evenlift/plane.h"
#include "evenlift/stands.h"
#include "state/browser.h"
#include "state/notice.h"
#include "tools/shorter_way.h"
#include "walkthrough/explain.h"

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

// The card about the robot stays with it.
void follow_card(AppState& state) {
  if (!state.explanation) return;
  const std::optional<std::size_t> number = state.explanation->robot;
  state.explanation.reset();
  if (!number) return;
  const auto [team, robot] = find_robot(state.placement->teams, *number);
  const Vec2& at = state.placement->teams[team].robots[robot].point.position;
  state.explanation = explain(state, {Pick::Kind::robot, team, static_cast<int>(robot), at});
}

// A team's robots are numbered by which of them is left: the one that is held may become the other.
void follow_grip(AppState& state, std::size_t number, std::size_t now) {
  if (number == now) return;
  const auto turn = [&](std::size_t& robot) {
    if (robot == number)
      robot = now;
    else if (robot == now)
      robot = number;
  };
  if (state.explanation && state.explanation->robot) turn(*state.explanation->robot);
  const auto [team, robot] = find_robot(state.placement->teams, now);
  if (state.held.kind == Pick::Kind::robot && state.held.index == team)
    state.held.end = static_cast<int>(robot);
}

// The number of a moved team's robot whose edge is kept.
std::size_t number_of(const Placement& placement, const MovedTeam& team) {
  const std::vector<Robot>& robots = placement.teams[team.team].robots;
  return team.team * robots.size() + (robots[0].point.edge == team.end.edge ? 0 : 1);
}

const MovedTeam* find_team(const Moved& moved, std::size_t team) {
  for (const MovedTeam& each : moved.teams)
    if (each.team == team) return &each;
  return nullptr;
}

// Notes that the robot that is held cannot go there; of one that is moved by keys a notice says so. O(n).
void refuse_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  if (state.held.kind == Pick::Kind::robot)
    state.closed_to = nearest_on_outline(state.placement->vertices(), to);
  else
    show(state, {Notice::Kind::info, closed_in_words(*state.placement, robot)});
}

// Where the robots come to if one of the first picture is moved: a balanced one to the point of the outline
// that is nearest to `to`, and its two neighbours so that all still bear the same; one of a team along its
// range towards `to`. Nothing if they stay; where others cannot follow it, the state notes where the
// robot is wanted that is held, and a notice tells it of one that is moved by keys. O(n log n).
std::optional<Moved> moved_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  state.closed_to.reset();
  if (state.refusal || !state.placement || state.placement->teams.empty()) return std::nullopt;
  const Placement& placement = *state.placement;
  if (can_move_teams(placement)) return moved_along_range(placement, robot, to);
  if (placement.settings.method != Method::balanced) return std::nullopt;
  auto moved = moved_along_outline(placement, robot, nearest_on_outline(placement.vertices(), to));
  if (!moved) refuse_by_hand(state, robot, to);
  return moved;
}

// Shows a placement in which this robot was moved, and takes over where its robots are. It ends the search.
void show_moved(AppState& state, std::size_t robot, Placement placement) {
  drop_search(state);
  state.placement = std::move(placement);
  state.document.moved = state.placed.moved = state.placement->moved;
  ++state.revision;
  forget_failures(state);
  const auto [team, end] = find_robot(state.placement->teams, robot);
  if (const MovedTeam* moved = find_team(state.document.moved, team))
    follow_grip(state, robot, number_of(*state.placement, *moved));
  renew_outlook(state);
  renew_failures(state);
  follow_card(state);
  browser::document_changed();
}

}  // namespace

void move_robot(AppState& state, std::size_t robot, const Vec2& to) {
  const std::optional<Moved> moved = moved_by_hand(state, robot, to);
  if (!moved || *moved == state.document.moved) return;
  Result<Placement> placement = with_moved(*state.placement, *moved);
  if (!placement) return refuse_by_hand(state, robot, to);  // two robots would meet
  begin_edit(state, true, Edit::robots_moved);
  show_moved(state, robot, std::move(placement).value());
}

void put_robots_back(AppState& state) {
  if (!state.document.moved.any()) return;
  begin_edit(state, false, Edit::robots_reset);
  recompute(state);
}

void put_teams_back(AppState& state) {
  if (!state.document.moved.teams.empty()) put_robots_back(state);
}

}  // namespace evenlift::view
