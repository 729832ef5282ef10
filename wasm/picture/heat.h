// The force that tips the object, as a heat map: for each point outside the lifting base, the least
// press down there that tips the object.
#pragma once

#include <vector>

#include "evenlift/placement.h"
#include "ui/heat_levels.h"

namespace evenlift::view {

// The part of the object, without its holes, where only a press down of at least `share` times the weight tips the
// object, as triangles: three points each. The innermost band has an infinite share: no press down
// there tips the object.
struct HeatBand {
  double share = 0;
  std::vector<Vec2> triangles;
  // For a polygon that is filled by rows: a convex region, counter-clockwise. The band is its part
  // inside the polygon. An empty region means the whole polygon.
  Points region;
};

// The bands from the outermost (share 0, the whole object) inwards; each is painted over the
// preceding one. `triangles` are the object's, from triangulate(), or empty. A band is an
// intersection of half-planes: the sides of the lifting base, moved outwards (algorithm.md,
// Stability). O(levels n h), where h is the number of sides of the lifting base with a part of the
// polygon beyond them.
std::vector<HeatBand> heat_bands(const Placement& placement,
                                 const std::vector<std::uint32_t>& triangles);

}  // namespace evenlift::view
