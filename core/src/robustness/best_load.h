// Finds the least possible greatest load of a robot, for a weight of 1 and C at the origin.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

// Uses the formula at best_load() (load_models.h), over all ordered pairs of robots. There must be
// at least one robot, and C must be inside the lifting base. O(m^3).
double best_share_by_pairs(const Points& robots);

// Uses cutting planes. Let S(b) be the sum of max(0, 1 + b . q) over the robots q. It is convex in
// b, and the share is 1 / (the least S(b)). `hull` is the lifting base, counter-clockwise, with C
// inside. O(m) for each of about a hundred steps.
double best_share_by_cuts(const Points& robots, const Points& hull);

// Finds the share for robots at points (t, 0), on one line with C. O(m log m).
double best_share_on_line(const Points& robots);

}  // namespace evenlift
