// What the canvas keeps of a placement's drawing from frame to frame: the shapes, the object as
// triangles, the heat map, and the progress of an animation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/output/picture.h"
#include "picture/heat.h"
#include "picture/labels.h"
#include "state/state.h"

namespace evenlift::view {

// With more vertices, including holes, a polygon is filled by rows (fill_rows.h).
inline constexpr std::size_t most_triangulated = 2000;

// More teams are dots, without animation.
inline constexpr std::size_t most_single_robots = 400;

struct Scene {
  std::uint64_t revision = 0;
  Overlays overlays;
  std::vector<Shape> shapes;  // of the last good placement, by the overlays
  std::vector<Points> holes;  // of its object
  // The object without the holes: the corners, and three of their indices for each triangle; no
  // triangles if it is filled by rows.
  Points corners;
  std::vector<std::uint32_t> triangles;
  std::vector<HeatBand> heat;  // computed on first request
  bool shows_heat() const { return overlays.tipping && !heat.empty(); }
  CoveragePlace coverage;  // where it appears, if there is room

  // The state before a change, for its animation, and the time of the change.
  Points hull_before, robots_before;
  double changed_at = -1;  // seconds
  float progress = 1;      // 0 .. 1
};

// Brings the scene up to date with the placement. Free while the document is unchanged, and one
// pass over the shapes if only the overlays change. `now` is in seconds.
void follow(Scene& scene, const AppState& state, const Placement& placement, double now);

// Before the change, for an animation.
bool stood_there(const Scene& scene, const Vec2& robot);

}  // namespace evenlift::view
