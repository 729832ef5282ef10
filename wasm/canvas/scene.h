// What the canvas draws of a placement, kept from frame to frame: the picture's shapes, the object
// as triangles, the heat map, and how far a change has moved there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "canvas/heat.h"
#include "canvas/labels.h"
#include "evenlift/output/picture.h"
#include "state/state.h"

namespace evenlift::view {

// A polygon of more vertices than this is filled by rows.
inline constexpr std::size_t most_triangulated = 2000;

// More teams than this are drawn as a swarm of dots, and nothing of them moves.
inline constexpr std::size_t most_single_robots = 400;

struct Scene {
  std::uint64_t revision = 0;
  Overlays overlays;
  std::vector<Shape> shapes;             // of the last good placement, as the overlays ask
  std::vector<std::uint32_t> triangles;  // of its polygon; none of a large one (fill_rows.h)
  std::vector<HeatBand> heat;            // once it has been asked for
  bool shows_heat() const { return overlays.tipping && !heat.empty(); }
  CoveragePlace coverage;  // where coverage is written, if there is room

  // A change on its way: what was there before, and since when.
  Points hull_before, robots_before;
  double changed_at = -1;  // seconds
  float progress = 1;      // 0 .. 1
};

// Follows the placement; costs nothing while the document stays as it is, and what is shown of it
// costs one pass over the shapes. `now` in seconds.
void follow(Scene& scene, const AppState& state, const Placement& placement, double now);

// Whether the robot stood there before the change.
bool stood_there(const Scene& scene, const Vec2& robot);

}  // namespace evenlift::view
