// Places in the picture, in pixels with y down.
#pragma once

#include "evenlift/vec.h"

namespace evenlift::svg {

// Maps polygon coordinates (y up) to pixels. The ground is the coloured area behind the object, and
// the object's box is in its middle.
struct Paper {
  // The object has `share` times its usual size (svg_style.h).
  Paper(const Points& vertices, double share);

  double width = 0, height = 0;  // the size of the ground
  double scale = 1;              // pixels per unit of length
  Vec2 middle;                   // the middle of the object's box, in polygon coordinates

  Vec2 operator()(const Vec2& p) const;
  Points operator()(const Points& points) const;
};

// The part of a convex area, segment or point that is on the ground. All are in pixels. O(points).
Points clipped(Points area, const Paper& paper);

// The outline, in pixels, without vertices that a reader cannot tell from the last one kept. O(n).
Points visible(const Points& outline);

}  // namespace evenlift::svg
