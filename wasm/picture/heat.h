// The force that tips the object, as a heat map: outside the lifting base, how hard a push at each
// point must be to tip it.
#pragma once

#include <vector>

#include "evenlift/placement.h"
#include "ui/heat_levels.h"

namespace evenlift::view {

// The part of the polygon where only a push of at least `share` times the weight tips the object,
// as triangles: three points each. The innermost band has an infinite share: no push there tips it.
struct HeatBand {
  double share = 0;
  std::vector<Vec2> triangles;
  // For a polygon that is filled by rows: a convex region, counter-clockwise. The band is its part
  // inside the polygon. If it is empty, the band is all of the polygon.
  Points region;
};

// The bands from the outermost (share 0, all of the polygon) inwards; each is painted over the one
// before. `triangles` are the polygon's, from triangulate(), or none. A band is an intersection of
// half-planes: the sides of the lifting base, moved outwards (algorithm.md, Stability).
// O(levels n h), where h sides of the lifting base have some of the polygon beyond them.
std::vector<HeatBand> heat_bands(const Placement& placement,
                                 const std::vector<std::uint32_t>& triangles);

}  // namespace evenlift::view
