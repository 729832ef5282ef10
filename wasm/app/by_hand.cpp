#include "app/by_hand.h"

#include <utility>

#include "app/outlook.h"
#include "app/search.h"
#include "evenlift/balanced.h"
#include "evenlift/plane.h"
#include "state/browser.h"
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
  const std::optional<std::size_t> robot = state.explanation->robot;
  state.explanation.reset();
  if (!robot) return;
  const Vec2& at = state.placement->teams[0].robots[*robot].point.position;
  state.explanation = explain(state, {Pick::Kind::robot, 0, static_cast<int>(*robot), at});
}

}  // namespace

void move_by_hand(AppState& state, std::size_t robot, const Vec2& to) {
  if (state.refusal || !state.placement || state.placement->teams.empty()) return;
  Placement& placement = *state.placement;
  if (placement.settings.method != Method::balanced) return;
  const BalancedProblem problem(placement.polygon, placement.centre_of_mass, placement.settings);
  const LiftingPoint wanted = nearest_on_outline(placement.vertices(), to);
  const auto robots = move_robot(problem, lifting_points(placement.teams), robot, wanted);
  state.closed_to.reset();
  if (!robots) {
    if (state.held.kind == Pick::Kind::robot) state.closed_to = wanted;
    return;
  }
  drop_search(state);
  state.placement = with_robots(std::move(placement), *robots, true);
  state.by_hand = true;
  ++state.revision;
  forget_failures(state);
  renew_outlook(state);
  renew_failures(state);
  follow_card(state);
  browser::summary_changed();
}

}  // namespace evenlift::view
