// The heat map, and what the canvas keeps from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/output/picture.h"
#include "evenlift/report.h"
#include "picture/labels.h"
#include "state/state.h"
#include "ui/theme.h"

namespace evenlift::view {

// --- The heat map shows, for each point outside the lifting base, the least downward press there that
// tips the object under the given conditions (tilt.h), if the robots push back and none is
// overloaded.

// The part of the object, without its holes, where only a downward press of at least `share` times
// the weight (with cargo) tips it. The innermost band has an infinite share: under the same
// conditions, no press there tips the object.
struct HeatBand {
  double share = 0;
  std::vector<Vec2> triangles;  // three points each
  // For a polygon so large that it is filled by rows (fill_rows.h): a convex, counter-clockwise
  // region, whose part inside the polygon is the band. Empty means the whole polygon.
  Points region;
};

// Returns the bands from the outermost (share 0, the whole object) inwards; each is painted over
// the preceding one. There are no bands if the lifting base has no area, and only the outermost if
// the object tips under the given conditions. `triangles` are the
// object's, from triangulate(); if they are empty, the bands have regions. A band is an
// intersection of half-planes: the sides of the lifting base, moved outwards (algorithm.md,
// Stability). O(levels n h) for n vertices and the h sides that have a vertex beyond them.
std::vector<HeatBand> heat_bands(const Reported& of, const std::vector<std::uint32_t>& triangles);

// --- The parts of a placement's drawing that the canvas keeps from frame to frame: the shapes, the
// object as triangles, the heat map, and the progress of an animation.

// A polygon with more vertices than this, including those of its holes, is filled by rows
// (fill_rows.h).
inline constexpr std::size_t most_triangulated = 2000;

// If there are more teams than this, their robots are drawn as dots, without animation.
inline constexpr std::size_t most_single_robots = 400;

struct Scene {
  std::uint64_t revision = 0;  // Derived::revision of the placement
  Overlays overlays;
  std::vector<Shape> shapes;  // of the last good placement, with these overlays
  std::vector<Points> holes;  // of the placement's object
  // The object without its holes: the corners, and three of their indices for each triangle. Both
  // are empty if the object is filled by rows.
  Points corners;
  std::vector<std::uint32_t> triangles;
  std::vector<HeatBand> heat;  // computed when it is first shown
  double heat_reach = 0;       // of the conditions (uncertainty.h) for which it was computed
  bool shows_heat() const { return overlays.tipping && !heat.empty(); }
  CoveragePlace coverage;  // where the coverage's number appears, if there is room

  // The state before a change, for its animation, and the time of the change.
  Points hull_before, robots_before;
  double changed_at = -1;  // seconds
  float progress = 1;      // 0 .. 1
};

// Brings the scene up to date with the placement. This costs nothing while the document and the
// overlays are unchanged; if only the overlays change, it costs one pass over the shapes. `now` is
// in seconds.
void follow(Scene& scene, const AppState& state, const Reported& of, double now);

// Returns whether a robot stood at this place before the change, for the animation.
bool stood_there(const Scene& scene, const Vec2& robot);

}  // namespace evenlift::view
