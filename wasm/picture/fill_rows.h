// Fills a large polygon row by row of device pixels. Triangles would be too many for a frame and
// take too long to compute; the size of this result is bounded by the window.
#pragma once

#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// The part of a row of pixels that is inside the polygon, in pixels.
struct RowSpan {
  float left, right, top;
};
struct RowFill {
  std::vector<RowSpan> spans;
  float height = 1;  // of a row
};

// The visible part of the polygon without its holes, by the even-odd rule at the middle of each
// pixel. An edge that the polygon passes in both directions has no effect. `pixel` is the size of a
// device pixel. If there would be more than a few hundred thousand spans, the rows are
// coarser. O(n + pixels + rows that the edges cross).
RowFill fill_rows(const Points& polygon, const std::vector<Points>& holes, const Camera& camera,
                  const Rect& window, double pixel);

}  // namespace evenlift::view
