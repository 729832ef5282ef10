// The margins of many grasps of one object. Only contacts far enough from corners count.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "grasp/contact_finder.h"
#include "grasp/wrench_margin.h"

namespace evenlift {

class Margins {
 public:
  // The polygon must outlive this object. Contacts nearer than `clear` to a corner do not count.
  // O(n log n).
  Margins(const Polygon& polygon, const Vec2& centre, double clear);

  // Returns the margin of analyse_hold() for the clear_contacts() of these points. O(m log n), and
  // the cost of wrench_margin().
  std::optional<double> of(const std::vector<LiftingPoint>& points) const;

  // The wrenches that the margin needs: for contacts on parallel edges, the first and the last.
  // O(m log n).
  std::vector<Wrench> wrenches_of(const std::vector<LiftingPoint>& points) const;

 private:
  const Polygon& polygon_;
  Vec2 centre_;
  double radius_, clear_;
  ContactFinder finder_;
};

}  // namespace evenlift
