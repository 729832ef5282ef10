// For each point outside the lifting base, the least press down there that tips the object.
#pragma once

#include <vector>

#include "evenlift/placement.h"
#include "ui/heat_levels.h"

namespace evenlift::view {

// The part of the object, without its holes, where only a press down of at least `share` times the
// weight tips it, as triangles: three points each. The innermost band has an infinite share: no
// press there tips it.
struct HeatBand {
  double share = 0;
  std::vector<Vec2> triangles;
  // For a polygon filled by rows: a convex region, counter-clockwise, whose part inside the polygon
  // is the band. Empty means the whole polygon.
  Points region;
};

// From the outermost band (share 0, the whole object) inwards; each is painted over the preceding
// one. `triangles` are the object's, from triangulate(), or empty. A band is an intersection of
// half-planes: the sides of the lifting base, moved outwards (algorithm.md, Stability). O(levels n
// h) for h sides with a part of the polygon beyond them.
std::vector<HeatBand> heat_bands(const Placement& placement,
                                 const std::vector<std::uint32_t>& triangles);

}  // namespace evenlift::view
