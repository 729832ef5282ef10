// A large polygon filled row by row of device pixels, with no triangles: their number, and the time
// to find them, would grow beyond what a frame can bear. What this gives is as large as the window.
#pragma once

#include <vector>

#include "state/camera.h"

namespace evenlift::view {

// Of one row of pixels, inside of the polygon; CSS pixels.
struct RowSpan {
  float left, right, top;
};
struct RowFill {
  std::vector<RowSpan> spans;
  float height = 1;  // of a row
};

// What of the polygon the window shows, by the even-odd rule at the middle of each pixel; `pixel`
// is the size of a device pixel. Where that gives too many spans for a picture (more than a few
// hundred thousand) the rows are coarser. O(n + pixels + rows that the edges cross).
RowFill fill_rows(const Points& polygon, const Camera& camera, const Rect& window, double pixel);

}  // namespace evenlift::view
