// A picture that lies behind the drawing, to be traced. The page draws it; the view knows where it lies.
#pragma once

#include <cstdint>

#include "evenlift/plane.h"

namespace evenlift::view {

struct Backdrop {
  Vec2 low, high;             // its corners, in polygon coordinates
  std::uint32_t picture = 0;  // which one it is, counted from the start
  bool traced = false;        // the open polygon was drawn on it
  bool operator==(const Backdrop&) const = default;
  double width() const { return high.x() - low.x(); }
};

}  // namespace evenlift::view
