// Fills a large polygon by rows of device pixels. Such a polygon would have too many triangles for
// a frame, and they would be slow to compute. The window bounds the number of rows and spans.
#pragma once

#include <vector>

#include "state/camera.h"

namespace evenlift::view {

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
