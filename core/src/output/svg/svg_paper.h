// Places in the picture, in pixels with y down.
#pragma once

#include "evenlift/vec.h"

namespace evenlift::svg {

// Maps polygon coordinates (y up) to pixels. The object's box is in the middle of the ground.
struct Paper {
  // The object is at most `share` of the usual size.
  Paper(const Points& vertices, double share);

  double width = 0, height = 0;  // of the ground
  double scale = 1;              // pixels per unit of length
  Vec2 middle = Vec2::Zero();    // of the object's box, in polygon coordinates

  Vec2 operator()(const Vec2& p) const;
  Points operator()(const Points& points) const;
};

// The part on the ground of a convex area, segment or spot in pixels. O(points).
Points clipped(Points area, const Paper& paper);

// In pixels, without vertices that look like the one before. O(n).
Points visible(const Points& outline);

}  // namespace evenlift::svg
