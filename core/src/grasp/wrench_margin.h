// The quality of a grasp: how far the origin lies inside the convex hull of the contacts' wrenches,
// or outside, which is negative (C. Ferrari and J. Canny, Planning optimal grasps, 1992; their
// measure is often called epsilon or Q1: one limit for the sum of all contact forces, the L1 form).
#pragma once

#include <Eigen/Core>
#include <vector>

namespace evenlift {

using Wrench = Eigen::Vector3d;  // force x, force y, torque

// The minimum over all unit vectors u of the maximum of u . w over the wrenches w, of which there
// must be at least one. If the origin is inside the hull, that is the radius of the largest ball
// about it within the hull; if it is outside, minus its distance from the hull. O(m^2) for up to 32
// wrenches; of more a hull of those that bound the ball, of which there are some tens as a rule,
// and O(m) for each of them.
double wrench_margin(const std::vector<Wrench>& wrenches);

// The same, and a unit vector u that nearly attains it. Of whatever wrenches, the maximum of u . w
// is an upper bound of their margin; this u makes it a good one for wrenches like the given ones.
struct WeakestDirection {
  double margin = 0;
  Wrench direction = Wrench::UnitX();
};
WeakestDirection weakest_direction(const std::vector<Wrench>& wrenches);

}  // namespace evenlift
