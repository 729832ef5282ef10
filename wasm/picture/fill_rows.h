// Fills a large polygon by rows of device pixels. Triangles would be too many for a frame and slow
// to compute; the window bounds the size of this result.
#pragma once

#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// A row's part inside the polygon, in pixels.
struct RowSpan {
  float left, right, top;
};
struct RowFill {
  std::vector<RowSpan> spans;
  float height = 1;  // of a row
};

// The visible part of the polygon without its holes, by the even-odd rule at each pixel's middle.
// An edge passed in both directions has no effect. `pixel` is a device pixel's size. Rows are
// coarser if there would be more than a few hundred thousand spans. O(n + pixels + rows that the
// edges cross).
RowFill fill_rows(const Points& polygon, const std::vector<Points>& holes, const Camera& camera,
                  const Rect& window, double pixel);

}  // namespace evenlift::view
