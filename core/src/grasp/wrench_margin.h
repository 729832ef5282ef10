// How far the origin lies inside (or, negative, outside) the hull of wrenches.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace evenlift {

using Wrench = Eigen::Vector3d;

// The minimum over unit vectors u of the maximum over wrenches of u . w; at least one wrench.
// Inside the hull that is the radius of the largest ball about the origin, outside minus the
// distance. O(m^2) for m wrenches.
double wrench_margin(const std::vector<Wrench>& wrenches);

}  // namespace evenlift
