// The quality of a grasp (C. Ferrari and J. Canny, Planning optimal grasps, 1992; their measure is
// often called epsilon or Q1: one limit for the sum of all contact forces, the L1 form).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace evenlift {

using Wrench = Eigen::Vector3d;  // force x, force y, torque

// The minimum over all unit vectors u of the maximum of u . w over the wrenches w. This is the
// radius of the largest ball about the origin in their convex hull; if the origin is outside, it is
// minus the hull's distance from the origin. There must be at least one wrench. O(m^2) for up to 32
// wrenches. For more, only a hull of the wrenches that bound the ball is made, usually a few dozen,
// and finding each takes O(m).
double wrench_margin(const std::vector<Wrench>& wrenches);

// The margin, and a unit vector u that nearly attains it. For any other wrenches w, the maximum of
// u . w is an upper bound of their margin. The bound is good if they are similar to the given ones.
struct WeakestDirection {
  double margin = 0;
  Wrench direction = Wrench::UnitX();
};
WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches);

}  // namespace evenlift
