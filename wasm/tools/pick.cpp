#include "tools/pick.h"

#include "evenlift/plane.h"

namespace evenlift::view {
namespace {

double distance(const Vec2& a, const Vec2& b) { return length(a - b); }

// The nearest candidate so far, if it is within reach.
struct Nearest {
  double reach;
  Pick pick = {};
  void offer(double away, const Pick& candidate) {
    if (away <= reach) {
      reach = away;
      pick = candidate;
    }
  }
};

Pick part_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{state.screen.touch ? 24.0 : 12.0};
  const Points& vertices = state.document.vertices;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    nearest.offer(distance(state.camera.to_screen(vertices[i]), screen),
                  {Pick::Kind::vertex, i, 0, vertices[i]});
  }
  const Vec2 centre = centre_of_mass(state);
  nearest.offer(distance(state.camera.to_screen(centre), screen),
                {Pick::Kind::centre, 0, 0, centre});
  return nearest.pick;
}

Pick robot_at(const AppState& state, const Placement& placement, const Vec2& screen) {
  Nearest nearest{14};
  const std::vector<Team>& teams = placement.teams;
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const Vec2 ends[2] = {teams[i].chord.r1.position, teams[i].chord.r2.position};
    for (int end = 0; end < 2; ++end) {
      nearest.offer(distance(state.camera.to_screen(ends[end]), screen),
                    {Pick::Kind::robot, i, end, ends[end]});
    }
  }
  return nearest.pick;
}

Pick edge_at(const AppState& state, const Vec2& screen) {
  Nearest nearest{state.screen.touch ? 16.0 : 8.0};
  const Points& vertices = state.document.vertices;
  const Vec2 world = state.camera.to_world(screen);
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], world);
    nearest.offer(distance(state.camera.to_screen(at), screen), {Pick::Kind::edge, i, 0, at});
  }
  return nearest.pick;
}

Pick chord_at(const AppState& state, const Placement& placement, const Vec2& screen) {
  Nearest nearest{6};
  const std::vector<Team>& teams = placement.teams;
  const Vec2 world = state.camera.to_world(screen);
  for (std::size_t i = 0; i < teams.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(teams[i].chord.r1.position, teams[i].chord.r2.position, world);
    nearest.offer(distance(state.camera.to_screen(at), screen), {Pick::Kind::chord, i, 0, at});
  }
  return nearest.pick;
}

}  // namespace

Vec2 centre_of_mass(const AppState& state) {
  if (state.document.centre_of_mass) return *state.document.centre_of_mass;
  if (state.placement) return state.placement->centre_of_mass;
  return state.document.vertices.empty() ? Vec2(0, 0) : state.document.vertices[0];
}

const Placement* current_placement(const AppState& state, bool second) {
  const std::optional<Placement>& placement = second ? state.second : state.placement;
  return placement && !state.refusal ? &*placement : nullptr;
}

Pick pick(const AppState& state, const Vec2& screen, bool second) {
  Pick found = part_at(state, screen);
  const Placement* placement = current_placement(state, second);
  if (found.kind == Pick::Kind::none && placement) found = robot_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none) found = edge_at(state, screen);
  if (found.kind == Pick::Kind::none && placement) found = chord_at(state, *placement, screen);
  if (found.kind == Pick::Kind::none && placement) {
    const Vec2 world = state.camera.to_world(screen);
    if (inside(placement->vertices, world)) found = {Pick::Kind::object, 0, 0, world};
  }
  found.second = second;
  return found;
}

}  // namespace evenlift::view
