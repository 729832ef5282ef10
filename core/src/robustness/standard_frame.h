// Coordinates in which a set of points has its centroid at the origin and the same mean square
// along every direction. The loads of springs are the same in all coordinates that are linear in
// each other, and in these a long and thin set is as good to compute with as a round one.
#pragma once

#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct StandardFrame {
  Vec2 mean = Vec2::Zero();
  // A point p has the coordinates axis[k] . (p - mean). They have the mean square 1. If all points
  // are within tolerance (tau) of one line the second axis is 0, and if they are within tolerance
  // of one place, both.
  Vec2 axis[2] = {Vec2::Zero(), Vec2::Zero()};

  Vec2 operator()(const Vec2& p) const { return {dot(axis[0], p - mean), dot(axis[1], p - mean)}; }
};

// The frame of points in units of L, of which there must be one. The first axis is along the point
// farthest from the centroid. O(m).
StandardFrame standard_frame(const Points& points);

}  // namespace evenlift
