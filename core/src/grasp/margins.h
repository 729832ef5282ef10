// Computes the margins of many placements on one object.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/closure.h"
#include "grasp/contact_finder.h"
#include "grasp/wrench_margin.h"

namespace evenlift {

class Margins {
 public:
  // The polygon must outlive this object. Contacts nearer than `hold.clear` to a corner do not
  // count. O(n log n).
  Margins(const Polygon& polygon, const Vec2& centre, const HoldRequirements& hold);

  // Returns the margin that analyse_hold() would compute from the contacts of robots at these
  // points, without those that do not count. Returns nothing if no contact counts. O(m log n) for m
  // points, plus the cost of wrench_margin().
  std::optional<double> of(const std::vector<LiftingPoint>& points) const;

  // The wrenches that the margin needs. Of several contacts on edges of the same direction, only
  // the first and the last are included (grasp.h). O(m log n).
  std::vector<Wrench> wrenches_of(const std::vector<LiftingPoint>& points) const;

  // Whether robots at these points, which have this margin, still hold the object if they are off
  // by `hold.tolerance`, within tau L. O(m log n), plus the cost of holds_within() (closure.h) if
  // the margin is small or a bend is near.
  bool are_firm(const std::vector<LiftingPoint>& points, const WeakestDirection& margin) const;

  // The level of these robots' margin (hold_levels.h); 0 if they are not firm. `tested` says whether
  // that was in question.
  struct Level {
    std::uint32_t level = 0;
    bool tested = false;
  };
  Level level_of(const std::vector<LiftingPoint>& points) const;

 private:
  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  HoldRequirements hold_;
  ContactFinder finder_;
};

}  // namespace evenlift
