// How far the parts of a robot may move if it is off along the outline.
#pragma once

#include <vector>

#include "evenlift/placement.h"
#include "robustness/load_errors.h"

namespace evenlift {

class RobotDrift {
 public:
  // The polygon must outlive this object. `contact` is the robot's contact, or its place beneath
  // the object. O(1).
  RobotDrift(const Polygon& polygon, const LiftingPoint& contact, bool in_notch);

  // The greatest way of the point that is this far from the contact, along the normal or against it,
  // if the robot is off by up to `error`. Past a bend, the normal turns. O(1), and O(vertices within
  // `error`) if `arm` is not 0.
  double way(double arm, double error) const;

  bool is_fixed() const { return in_notch_; }

 private:
  const Polygon& polygon_;
  LiftingPoint contact_;
  bool in_notch_;
};

// The drifts of all robots of a placement, in their order. O(m log n).
std::vector<RobotDrift> drifts_of(const Placement& placement);

// Where these robots, which have these drifts, may be off. O(m).
std::vector<ErrorDirection> error_directions(const Placement& placement,
                                             const std::vector<RobotDrift>& drifts);

}  // namespace evenlift
