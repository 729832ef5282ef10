// The two ways to the least possible greatest load, for a weight of 1 and C at the origin.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// By the closed formula, over all ordered pairs of robots, of which there must be one. C must be
// inside their hull. O(m^3).
double best_share_by_pairs(const Points& robots);

// By cutting planes: with g(q) = 1 + b . q the share is the greatest of 1 / (sum of max(0, g)) over
// all b, and the sum is a convex function of b. `hull` are the corners of the robots' convex hull,
// counter-clockwise, with C inside. O(m) for each of some hundred steps.
double best_share_by_cuts(const Points& robots, const Points& hull);

// If robots and C are on a line, the robots at (t, 0). O(m log m).
double best_share_on_line(const Points& robots);

}  // namespace evenlift
