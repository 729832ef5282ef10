// The canvas's drawing of a placement, kept from frame to frame: the picture's shapes, the object
// as triangles, the heat map, and the progress of an animation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/output/picture.h"
#include "picture/heat.h"
#include "picture/labels.h"
#include "state/state.h"

namespace evenlift::view {

// A polygon that has more vertices than this with its holes is filled by rows (fill_rows.h).
inline constexpr std::size_t most_triangulated = 2000;

// More teams than this are drawn as dots, without animation.
inline constexpr std::size_t most_single_robots = 400;

struct Scene {
  std::uint64_t revision = 0;
  Overlays overlays;
  std::vector<Shape> shapes;  // of the last good placement, by the overlays
  std::vector<Points> holes;  // of its object
  // Its object without the holes: the corners, and their indices, three for each triangle. No
  // triangles if it is filled by rows.
  Points corners;
  std::vector<std::uint32_t> triangles;
  std::vector<HeatBand> heat;  // computed on first request
  bool shows_heat() const { return overlays.tipping && !heat.empty(); }
  CoveragePlace coverage;  // where the coverage appears, if there is room

  // The animation of a change: the former state, and the time of the change.
  Points hull_before, robots_before;
  double changed_at = -1;  // seconds
  float progress = 1;      // 0 .. 1
};

// Brings the scene up to date with the placement. Costs nothing while the document is unchanged,
// and one pass over the shapes if only the overlays change. `now` is in seconds.
void follow(Scene& scene, const AppState& state, const Placement& placement, double now);

// Whether a robot stood at this point before the change.
bool stood_there(const Scene& scene, const Vec2& robot);

}  // namespace evenlift::view
