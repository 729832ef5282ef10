// Whether a hold survives robots that are off along the outline (algorithm.md, Clearance and
// tolerance). holds_within() in evenlift/closure.h explains it.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/closure.h"
#include "grasp/wrench_margin.h"

namespace evenlift {

class HoldErrors {
 public:
  // The polygon must outlive this object; `radius` is R. O(m log m) for m contacts.
  HoldErrors(const Polygon& polygon, const Vec2& centre, double radius,
             const std::vector<Contact>& contacts);

  // Whether form closure surely persists if all robots are off by up to `error`. `known` is the
  // margin of some of the contacts farther than that from corners, and its direction. With it the
  // answer is mostly found at once: the margin is large enough, or the moments alone end the hold in
  // that direction.
  bool hold_within(double error, const WeakestDirection& known = {}) const;

  // The supremum of the errors within which form closure persists; infinite if there is none.
  double tolerance() const;

 private:
  struct Push {
    Contact contact;
    Wrench wrench;
  };
  struct Reached {
    const Push* push;
    double beside;  // the greatest distance of a wrench within reach from those on its own side
  };

  bool hold_without_others() const;
  Wrench wrench_at(const Vec2& position, std::uint32_t edge) const;
  double beside(const Push& push, double error) const;
  std::vector<Reached> reached(double error) const;
  bool is_lost_along(const Wrench& direction, double error) const;
  double least_margin(const std::vector<Reached>& all, double most_beside, double error) const;

  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  std::vector<Push> pushes_;
};

}  // namespace evenlift
