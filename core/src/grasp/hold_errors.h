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

  // Whether form closure surely persists if all robots are off by up to `error`. `margin` is a lower
  // bound of the margin of the contacts farther than that from corners; with it the answer is found
  // at once where no robot can reach a bend.
  bool hold_within(double error, double margin = 0) const;

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
  double margin(const std::vector<Reached>& all, double most_beside, double turn) const;

  const Polygon& polygon_;
  Vec2 centre_;
  double radius_;
  std::vector<Push> pushes_;
};

}  // namespace evenlift
