// A simple polygon as triangles, to fill it.
//
// mapbox/earcut.hpp does the same, natively in 0.74 to 1.25 times the processor time (stars, combs,
// circles of 1,000 and 20,000 vertices). It can replace this file once it is also measured in the
// page.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// Indices of vertices, three a triangle. For drawing only: plain doubles, always ends, and what is
// not simple (an edit passes through such states) gives some triangles. Ears are looked for only
// among the vertices near them, found by Z-order: little more than O(n) for most shapes, O(n²) for
// some, so large polygons are filled by rows instead (fill_rows.h).
std::vector<std::uint32_t> triangulate(const Points& vertices);

}  // namespace evenlift::view
