// The force that tips the object as a heat map: how far out of the lifting base one can push how
// hard.
#pragma once

#include <vector>

#include "evenlift/placement.h"
#include "state/heat_levels.h"

namespace evenlift::view {

// The part of the polygon where a push of `share` times the weight is needed to tip, or more, as
// triangles: three points each. The innermost, without a level, is where none tips.
struct HeatBand {
  double share = 0;
  std::vector<Vec2> triangles;
  // Of a polygon without triangles, which is filled by rows: the convex region, counter-clockwise,
  // whose part within the polygon this is; none for all of it.
  Points region;
};

// From the outermost, which is all of the polygon (share 0), inwards: each is painted over the one
// before. `triangles` are the polygon's, as triangulate() gives them, or none. Where a force tips
// is an intersection of half-planes, the sides of H moved outwards (algorithm.md, Stability).
// O(levels n h), h the sides of H beyond which some of the polygon lies.
std::vector<HeatBand> heat_bands(const Placement& placement,
                                 const std::vector<std::uint32_t>& triangles);

}  // namespace evenlift::view
