// A simple polygon as triangles, to fill it.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift::view {

// Indices of vertices, three a triangle. For drawing only: plain doubles, always ends, and what is
// not simple (an edit passes through such states) gives some triangles. About O(n log n) for the
// shapes that people draw: ears are looked for only among the vertices near them, found by Z-order.
std::vector<std::uint32_t> triangulate(const Points& vertices);

}  // namespace evenlift::view
