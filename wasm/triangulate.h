// A simple polygon as triangles, to fill it.
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
