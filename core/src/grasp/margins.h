// Computes the margins of many placements on one object.
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

  // Returns the margin that analyse_hold() would compute from the contacts of robots at these
  // points, without those that do not count. Returns nothing if no contact counts. O(m log n) for m
  // points, plus the cost of wrench_margin().
  std::optional<double> of(const std::vector<LiftingPoint>& points) const;

  // The wrenches that the margin needs. Of several contacts on edges of the same direction, only
  // the first and the last are included (grasp.h). O(m log n).
  std::vector<Wrench> wrenches_of(const std::vector<LiftingPoint>& points) const;

 private:
  const Polygon& polygon_;
  Vec2 centre_;
  double radius_, clear_;
  ContactFinder finder_;
};

}  // namespace evenlift
