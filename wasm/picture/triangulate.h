// Divides a polygon, perhaps with holes, into triangles, to fill it.
//
// This is the ear clipping of mapbox/earcut.hpp. The library itself would have to be fetched for
// every build, since distributions do not package it, and its speed is similar (0.74 to 1.25 times
// the time for stars, combs and circles of 1,000 and 20,000 vertices).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// Indices of vertices, three for each triangle, in the polygon's and then each hole's vertices. Each
// hole is a ring in either orientation. For drawing only: it computes in plain doubles, always ends,
// and returns some triangles even for a polygon that is not simple, since edits pass through such
// states. To test an ear it examines only the vertices near it, which it finds by Z-order. Little
// more than O(n) for most shapes, but O(n²) for some, so large polygons are filled by rows instead
// (fill_rows.h); and O(holes n) for the holes.
std::vector<std::uint32_t> triangulate(const Points& vertices,
                                       const std::vector<Points>& holes = {});

// The vertices to which the indices refer. O(n).
Points joined(const Points& vertices, const std::vector<Points>& holes);

}  // namespace evenlift::view
