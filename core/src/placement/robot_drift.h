// Completes placements, finds an accuracy with room, and follows robots that are off.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placement.h"
#include "robustness/support.h"

namespace evenlift {

// --- Completes a placement, and moves its robots.

// Computes all values that follow from the teams, such as loads and coverage. O(n log n).
void describe_grasp(Placement& placement);

// Moves robots as with_moved() (moved.h) does, or returns an error that says why they cannot stand
// there. O(n log n).
std::optional<InputError> move_robots(Placement& placement, const Moved& moved);

// --- When robots that may be off by the setting `accuracy` have no room: with which they would have.

// An accuracy below `asked` for which `has_room` is true: about the greatest down to 1/64 of it.
// Empty if there is none. Calls has_room() at most nine times.
template <class HasRoom>
std::optional<double> less_accuracy(double asked, const HasRoom& has_room) {
  constexpr int most_halvings = 6;
  double less = asked;
  for (int i = 0; i < most_halvings; ++i) {
    less /= 2;
    if (!has_room(less)) continue;
    for (const double more : {1.75 * less, 1.5 * less, 1.25 * less})
      if (has_room(more)) return more;
    return less;
  }
  return std::nullopt;
}

// --- How far the parts of a robot may move if it is off along the outline.

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
