#include "app/by_hand.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "app/outlook.h"
#include "app/search.h"
#include "evenlift/balanced.h"
#include "evenlift/candidates.h"
#include "evenlift/placed_robots.h"
#include "evenlift/plane.h"
#include "evenlift/stands.h"
#include "state/browser.h"
#include "tools/pick.h"
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

// Shows a placement whose robots somebody moved.
void show_moved(AppState& state, Placement placement) {
  drop_search(state);
  state.placement = std::move(placement);
  state.by_hand = true;
  ++state.revision;
  forget_failures(state);
  renew_outlook(state);
  renew_failures(state);
  follow_card(state);
  browser::summary_changed();
}

// The place of a range at which C sees the robot on edge a in a direction, or the nearest one.
double place_towards(const PairRange& range, const Vec2& direction) {
  const double first = cross(range.a0, direction), last = cross(range.a1, direction);
  // C sees the edge under less than 180 degrees, so the two differ in sign where it sees the place.
  const double x = first == last ? range.first : first / (first - last);
  const bool ahead = dot((1 - x) * range.a0 + x * range.a1, direction) > 0;
  if (ahead) return std::clamp(x, range.first, range.last);
  return std::fabs(first) < std::fabs(last) ? range.first : range.last;
}

// The chord of the ranges whose robot on edge a is seen from C nearest to a direction.
std::optional<Chord> chord_towards(const std::vector<PairRange>& ranges, const Vec2& centre,
                                   const Vec2& direction) {
  std::optional<Chord> nearest;
  double best = 0;
  for (const PairRange& range : ranges) {
    const double x = place_towards(range, direction);
    const Vec2 offset = (1 - x) * range.a0 + x * range.a1;
    const double cosine = dot(offset, direction) / length(offset);
    if (nearest && cosine <= best) continue;
    nearest = chord_at(centre, range, x);
    best = cosine;
  }
  return nearest;
}

bool any_collide(const Placement& placement) {
  return placement.stands && placement.stands->any_collide(lifting_points(placement.teams));
}

// A team goes along its range, so far as its chord stays even enough, and robots with a size can stand
// there without meeting others.
void move_team(AppState& state, std::size_t number, const Vec2& to) {
  const Placement& placement = *state.placement;
  const auto [team, robot] = find_robot(placement.teams, number);
  const Vec2& centre = placement.centre_of_mass;
  Chord chord = chord_of(placement.teams[team]);
  // Edge a of the range is that of the robot.
  if (robot == 1) std::swap(chord.r1, chord.r2);
  if (!(length(to - centre) > 0)) return;
  const auto towards = chord_towards(ranges_of(placement, chord), centre, to - centre);
  if (!towards) return;
  state.closed_to.reset();
  Placement moved = with_chord(placement, team, *towards);
  if (!any_collide(moved)) return show_moved(state, std::move(moved));
  if (state.held.kind == Pick::Kind::robot)
    state.closed_to = nearest_on_outline(placement.vertices(), to);
}

}  // namespace

void move_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  if (state.refusal || !state.placement || state.placement->teams.empty()) return;
  Placement& placement = *state.placement;
  if (can_move_teams(placement)) return move_team(state, robot, to);
  if (placement.settings.method != Method::balanced) return;
  const BalancedProblem problem(placement.polygon, placement.centre_of_mass, placement.settings);
  const LiftingPoint wanted = nearest_on_outline(placement.vertices(), to);
  const auto robots = move_robot(problem, lifting_points(placement.teams), robot, wanted);
  state.closed_to.reset();
  if (!robots) {
    if (state.held.kind == Pick::Kind::robot) state.closed_to = wanted;
    return;
  }
  show_moved(state, with_robots(std::move(placement), *robots, true));
}

}  // namespace evenlift::view
