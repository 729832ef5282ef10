// Divides a simple polygon into triangles, to fill it.
//
// This is the ear clipping of mapbox/earcut.hpp, for polygons without holes. The library itself
// would have to be fetched for every build, since distributions do not package it, and its speed is
// similar (0.74 to 1.25 times the time for stars, combs and circles of 1,000 and 20,000 vertices).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// Indices of vertices, three for each triangle. For drawing only: it computes in plain doubles,
// always ends, and returns some triangles even for a polygon that is not simple, since edits pass
// through such states. To test an ear it examines only the vertices near it, which it finds by
// Z-order. Little more than O(n) for most shapes, but O(n²) for some, so large polygons are filled
// by rows instead (fill_rows.h).
std::vector<std::uint32_t> triangulate(const Points& vertices);

}  // namespace evenlift::view
