#include "tools/support_spots.h"

#include "evenlift/plane.h"
#include "evenlift/supports.h"
#include "state/camera.h"

namespace evenlift::view {
namespace {

// The nearest vertex or else the nearest point, within reach.
std::optional<Vec2> on_outline(const Points& vertices, const Vec2& to, double reach) {
  std::optional<Vec2> edge;
  double least = reach;
  for (const Vec2& vertex : vertices) {
    if (length(vertex - to) > least) continue;
    least = length(vertex - to);
    edge = vertex;
  }
  if (edge) return edge;
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vec2 at =
        nearest_on_segment(vertices[i], vertices[i + 1 == vertices.size() ? 0 : i + 1], to);
    if (length(at - to) > least) continue;
    least = length(at - to);
    edge = at;
  }
  return edge;
}

}  // namespace

std::optional<Vec2> even_spot(const AppState& state, const Vec2& to,
                              std::optional<std::size_t> robot, double reach) {
  const Placement& placement = *state.derived().placement;
  const SupportPlacer placer(placement.object, placement.settings);
  const Points robots = positions(lifting_points(placement.teams));
  std::optional<Vec2> nearest;
  double least = reach / state.view.camera.scale;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (robot == i) continue;
    const Vec2 opposite = 2 * placement.centre_of_mass - robots[i];
    if (length(opposite - to) > least || !placer.place(opposite)) continue;
    least = length(opposite - to);
    nearest = opposite;
  }
  return nearest;
}

std::optional<Vec2> support_spot(const AppState& state, const Vec2& to,
                                 std::optional<std::size_t> robot) {
  if (const auto even = even_spot(state, to, robot, even_reach)) return even;
  const Placement& placement = *state.derived().placement;
  if (const auto edge = on_outline(placement.vertices(), to, edge_reach / state.view.camera.scale))
    return edge;
  if (!inside(placement.vertices(), to) || placement.object.hole_around(to)) return std::nullopt;
  return rounded_to_pixels(state.view.camera, to);
}

bool holds_support(const AppState& state) {
  return state.view.held.kind == Pick::Kind::robot && state.work.edit_open &&
         state.work.document().settings.method == Method::given;
}

}  // namespace evenlift::view
