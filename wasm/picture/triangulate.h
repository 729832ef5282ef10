// Divides a polygon, which may have holes, into triangles, so that it can be filled.
//
// This is the ear clipping of mapbox/earcut.hpp. The library itself would have to be fetched for
// every build, since distributions do not package it. This code is about as fast as the library: it
// takes 0.74 to 1.25 times as long for stars, combs and circles of 1,000 and 20,000 vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/vec.h"
#include "state/camera.h"

namespace evenlift::view {

// Returns three indices for each triangle, in either orientation. Indices number the vertices of
// the polygon and then of each hole. This function is for drawing only: it computes in plain
// doubles, always ends, and returns some triangles even for a polygon that is not simple, as can
// occur during edits. To test an ear, it examines only nearby vertices, which it finds by
// Z-order. The function costs little more than O(n) for most shapes, but O(n²) for some, so large
// polygons are filled by rows (fill_rows.h). The holes cost O(holes n).
std::vector<std::uint32_t> triangulate(const Points& vertices,
                                       const std::vector<Points>& holes = {});

// Returns the points to which triangulate()'s indices refer. O(n).
Points joined(const Points& vertices, const std::vector<Points>& holes);

// --- Fills a large polygon by rows of device pixels. Such a polygon would have too many triangles for
// a frame, and they would be slow to compute. The window bounds the number of rows and spans.

// One part of a row that is inside the polygon, in pixels.
struct RowSpan {
  float left, right, top;
};
struct RowFill {
  std::vector<RowSpan> spans;
  float height = 1;  // of a row, in pixels
};

// Returns the visible part of the polygon without its holes. The even-odd rule decides at each
// pixel's middle, so an edge that the outline passes in both directions has no effect. `pixel` is
// the size of a device pixel. Larger pixels, and so higher rows, are used if there would otherwise
// be more than a few hundred thousand spans. O(n + pixels + rows that the edges cross).
RowFill fill_rows(const Points& polygon, const std::vector<Points>& holes, const Camera& camera,
                  const Rect& window, double pixel);

}  // namespace evenlift::view
