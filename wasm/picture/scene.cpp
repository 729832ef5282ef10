#include "picture/scene.h"

#include <algorithm>
#include <cmath>

#include "picture/triangulate.h"

namespace evenlift::view {
namespace {

constexpr double motion_seconds = 0.16;
constexpr std::size_t most_lines = 100000;  // of candidates or chords

Points robots_of(const std::vector<Shape>& shapes) {
  Points robots;
  for (const Shape& shape : shapes) {
    if (shape.role == Role::robot) robots.push_back(shape.points[0]);
  }
  return robots;
}

Points hull_of(const std::vector<Shape>& shapes) {
  const auto hull = std::find_if(shapes.begin(), shapes.end(),
                                 [](const Shape& s) { return s.role == Role::lifting_base; });
  return hull == shapes.end() ? Points() : hull->points;
}

// Animates a change of the teams, except during a drag.
void begin_motion(Scene& scene, const AppState& state, const std::vector<Shape>& before,
                  double now) {
  scene.progress = 1;
  const bool many =
      state.derived().placement && state.derived().placement->teams.size() > most_single_robots;
  const bool wanted = state.view.motion && !state.session.screen.reduced_motion && !many;
  const bool moved = state.work.edit_open || state.view.held.kind == Pick::Kind::robot;  // by hand
  if (!wanted || moved || before.empty() || scene.shapes.empty()) return;
  if (before[0].points != scene.shapes[0].points) return;  // another polygon
  scene.hull_before = hull_of(before);
  scene.robots_before = robots_of(before);
  if (scene.robots_before == robots_of(scene.shapes) && scene.hull_before == hull_of(scene.shapes))
    return;
  scene.changed_at = now;
  scene.progress = 0;
}

void follow_object(Scene& scene, const PolygonWithHoles& object) {
  scene.holes = object.rings_of_holes();
  scene.corners = joined(object.outline().vertices(), scene.holes);
  scene.triangles.clear();
  if (scene.corners.size() <= most_triangulated)
    scene.triangles = triangulate(object.outline().vertices(), scene.holes);
  else
    scene.corners.clear();
}

// Everything that depends on the placement, not on the overlays.
void follow_anew(Scene& scene, const AppState& state, const Placement& placement,
                 const std::vector<Shape>& before, double now) {
  const bool same_object = !before.empty() && before[0].points == placement.vertices() &&
                           scene.holes == placement.object.rings_of_holes();
  if (!same_object) follow_object(scene, placement.object);
  scene.heat.clear();
  scene.coverage = place_coverage(placement, scene.coverage.at);
  scene.revision = state.derived().revision;
  begin_motion(scene, state, before, now);
}

}  // namespace

void follow(Scene& scene, const AppState& state, const Reported& of, double now) {
  const Placement& placement = of.placement;
  const Overlays& overlays = shown(state).overlays;
  const bool anew = scene.revision != state.derived().revision;
  if (anew || !(scene.overlays == overlays)) {
    const std::vector<Shape> before = std::move(scene.shapes);
    scene.shapes = make_picture(placement, overlays, most_lines);
    scene.overlays = overlays;
    if (anew) follow_anew(scene, state, placement, before, now);
  }
  if (overlays.tipping) {
    const double reach = of.report.effect.reach;
    if (scene.heat.empty() || reach != scene.heat_reach)
      scene.heat = heat_bands(of, scene.triangles);
    scene.heat_reach = reach;
  }
  if (scene.progress < 1) {
    const double share = std::clamp((now - scene.changed_at) / motion_seconds, 0.0, 1.0);
    scene.progress = static_cast<float>(1 - std::pow(1 - share, 3));  // ease-out
  }
}

bool stood_there(const Scene& scene, const Vec2& robot) {
  return std::find(scene.robots_before.begin(), scene.robots_before.end(), robot) !=
         scene.robots_before.end();
}

}  // namespace evenlift::view
