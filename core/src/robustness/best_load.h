// The least possible greatest load, for a weight of 1 and C at the origin.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// By the closed formula, over all ordered pairs. Needs at least one robot, and C inside the lifting
// base. O(m^3).
double best_share_by_pairs(const Points& robots);

// By cutting planes. With g(q) = 1 + b . q the share is the greatest of 1 / (sum of max(0, g)) over
// all b, and the sum is convex in b. `hull` is the lifting base, counter-clockwise, with C inside.
// O(m) for each of about a hundred steps.
double best_share_by_cuts(const Points& robots, const Points& hull);

// Robots (t, 0) on one line with C. O(m log m).
double best_share_on_line(const Points& robots);

}  // namespace evenlift
