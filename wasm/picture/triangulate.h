// Divides a polygon, perhaps with holes, into triangles, to fill it.
//
// This is the ear clipping of mapbox/earcut.hpp. The library itself would have to be fetched for
// every build, since distributions do not package it, and is about as fast (0.74 to 1.25 times the
// time for stars, combs and circles of 1,000 and 20,000 vertices).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// Three indices for each triangle, of the polygon's vertices and then each hole's, in either
// orientation. For drawing only: it computes in plain doubles, always ends, and returns some
// triangles even for a polygon that is not simple, which edits may pass through. To test an ear it
// examines only nearby vertices, found by Z-order. Little more than O(n) for most shapes, but O(n²)
// for some, so large polygons are filled by rows (fill_rows.h). O(holes n) for the holes.
std::vector<std::uint32_t> triangulate(const Points& vertices,
                                       const std::vector<Points>& holes = {});

// To which the indices refer. O(n).
Points joined(const Points& vertices, const std::vector<Points>& holes);

}  // namespace evenlift::view
