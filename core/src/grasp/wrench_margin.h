// The margin of a grasp, by C. Ferrari and J. Canny (Planning optimal grasps, 1992). Their measure
// is often called epsilon or Q1. This is the L1 form, with one limit for the sum of all contact
// forces.
#pragma once

#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

using Wrench = Vec3;  // force x, force y, torque

// The minimum over all unit vectors u of the maximum of u . w over the wrenches w. This is the
// radius of the largest ball about the origin in their convex hull; if the origin is outside, it is
// minus the hull's distance from the origin. There must be at least one wrench. O(m^2) for up to 32
// wrenches. For more, the hull is built only from the wrenches that bound the ball, usually a few
// dozen; finding each of these takes O(m).
double wrench_margin(const std::vector<Wrench>& wrenches);

// The margin, and a unit vector u for which the maximum of u . w is nearly the margin. For any
// other set of wrenches w, the maximum of u . w is an upper bound of that set's margin. The bound
// is close if the set is similar to the given one.
struct WeakestDirection {
  double margin = 0;
  Wrench direction{1, 0, 0};
};
WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches);

}  // namespace evenlift
