#include "picture/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

#include "evenlift/plane.h"
#include "picture/triangulate.h"

namespace evenlift::view {
namespace {

// A side of the lifting base. Distances beyond it are in units of its distance from the farthest
// place towards it where the weight may act.
struct Side {
  Vec2 a, along;
  double within;
  double beyond(const Vec2& p) const { return -cross(along, p - a) / within; }
};

// With thousands of corners a base is practically round: not all of its sides are needed.
constexpr std::size_t most_sides = 1000;

// Those with a vertex beyond them; the others cut nothing off. The weight acts within `reach` of C.
std::vector<Side> cutting_sides(const Placement& placement, double reach) {
  std::vector<Side> sides;
  const Points& hull = placement.lifting_base;
  const std::size_t step = (hull.size() + most_sides - 1) / most_sides;
  for (std::size_t i = 0; i < hull.size(); i += step) {
    const Vec2 along = hull[i + 1 == hull.size() ? 0 : i + 1] - hull[i];
    Side side{hull[i], along,
              cross(along, placement.centre_of_mass - hull[i]) - reach * length(along)};
    // At the very edge, nearly any press tips it.
    if (reach > 0) side.within = std::max(side.within, 1e-9 * reach * length(along));
    if (!(side.within > 0)) continue;
    const bool cuts = std::any_of(placement.vertices().begin(), placement.vertices().end(),
                                  [&](const Vec2& p) { return side.beyond(p) > 0; });
    if (cuts) sides.push_back(side);
  }
  return sides;
}

// Keeps the part at most `most` beyond the side. `spare` is memory for reuse.
void cut(Points& area, const Side& side, double most, Points& spare) {
  clip(
      area, [&](const Vec2& p) { return most - side.beyond(p); }, spare);
  area.swap(spare);
}

// With ample room, counter-clockwise.
Points frame_around(const Points& polygon) {
  const Box box = bounding_box(polygon);
  const Vec2 low = box.low - box.size(), high = box.high + box.size();
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

HeatBand band(const Placement& placement, const Points& corners,
              const std::vector<std::uint32_t>& triangles, const std::vector<Side>& sides,
              double share) {
  HeatBand result{share, {}, {}};
  const double most = share > 0 ? 1 / share : std::numeric_limits<double>::infinity();
  if (triangles.empty() && share > 0) {
    Points spare;
    result.region = frame_around(placement.vertices());
    for (const Side& side : sides) {
      if (!result.region.empty()) cut(result.region, side, most, spare);
    }
    return result;
  }
  Points area, spare;
  for (std::size_t i = 0; i + 2 < triangles.size(); i += 3) {
    area.assign({corners[triangles[i]], corners[triangles[i + 1]], corners[triangles[i + 2]]});
    for (const Side& side : sides) {
      if (share == 0 || area.empty()) break;
      cut(area, side, most, spare);
    }
    for (std::size_t j = 2; j < area.size(); ++j) {
      result.triangles.insert(result.triangles.end(), {area[0], area[j - 1], area[j]});
    }
  }
  return result;
}

}  // namespace

std::vector<HeatBand> heat_bands(const Reported& of, const std::vector<std::uint32_t>& triangles) {
  const Placement& placement = of.placement;
  if (placement.lifting_base.size() < 3) return {};
  const std::vector<Side> sides = cutting_sides(placement, of.report.effect.reach);
  const Points corners = joined(placement.vertices(), placement.object.rings_of_holes());
  std::vector<HeatBand> bands;
  const auto add = [&](double share) {
    bands.push_back(band(placement, corners, triangles, sides, share));
  };
  add(0);
  if (of.report.tips) return bands;
  for (const double level : heat_levels) add(level);
  add(std::numeric_limits<double>::infinity());
  return bands;
}

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
