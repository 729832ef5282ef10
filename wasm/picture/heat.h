// The heat map shows, for each point outside the lifting base, the least downward press there that
// tips the object under the given conditions (tilt.h), if the robots push back and none is
// overloaded.
#pragma once

#include <vector>

#include "evenlift/report.h"
#include "ui/heat_levels.h"

namespace evenlift::view {

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

}  // namespace evenlift::view
