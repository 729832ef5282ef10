// The quality of a grasp (C. Ferrari and J. Canny, Planning optimal grasps, 1992; their measure is
// often called epsilon or Q1: one limit for the sum of all contact forces, the L1 form).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace evenlift {

using Wrench = Eigen::Vector3d;  // force x, force y, torque

// The minimum over all unit vectors u of the maximum of u . w over the wrenches w, at least one:
// the radius of the largest ball about the origin in their convex hull, or minus the hull's
// distance from an origin outside. O(m^2) for up to 32 wrenches; for more, a hull of those that
// bound the ball, usually some tens, and O(m) for each.
double wrench_margin(const std::vector<Wrench>& wrenches);

// The margin, and a unit vector u that nearly attains it. For any wrenches, the maximum of u . w is
// an upper bound of their margin, a good one if they are similar to the given ones.
struct WeakestDirection {
  double margin = 0;
  Wrench direction = Wrench::UnitX();
};
WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches);

}  // namespace evenlift
