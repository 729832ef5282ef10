// Coordinates in which points have their centroid at the origin and the same mean square along
// every direction. Linear changes of coordinates do not change the loads of springs, but in
// these coordinates a long, thin set is as well conditioned as a round one.
#pragma once

#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

struct StandardFrame {
  Vec2 mean;
  // The coordinates of a point p are axis[k] . (p - mean); each has the mean square 1. The second
  // axis is 0 if the points are on one line within tau, and both are 0 if the points are at one
  // place within tau.
  Vec2 axis[2] = {};

  Vec2 operator()(const Vec2& p) const { return {dot(axis[0], p - mean), dot(axis[1], p - mean)}; }
};

// Returns the frame of one or more points, whose coordinates are in units of L. Its first axis has
// the direction from the centroid to the farthest point. O(m).
StandardFrame standard_frame(const Points& points);

}  // namespace evenlift
