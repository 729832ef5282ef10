// The sets that complete some robots so that the centroid of all is C.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// Where the middle of two more robots must be, so that C is the centroid of all.
Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// The even candidates whose two ends, with these robots, have the centroid C: of outlines with more
// than 1,000 vertices some of them if there are many (EvenChords::some_about).
std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots);

// The same, and always all of them.
std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots);

// Keeps the best of the sets that are offered to it; of equal ones the first.
class Best {
 public:
  explicit Best(const Rules& rules) : rules_(rules) {}

  // Offers robots with two more, or with three more, in their order.
  void offer(const RatedSet& set) { set_ = set; }
  void offer_two_more(const std::vector<LiftingPoint>& robots);
  void offer_three_more(const std::vector<LiftingPoint>& robots);
  // The same with the first of the three at this place.
  void offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place);

  const std::optional<RatedSet>& set() const { return set_; }
  // Whether a set that was completed is the best.
  bool completed() const { return completed_; }
  // How many of the best set's robots, the first ones, were there before it was completed.
  std::size_t kept() const { return kept_; }

 private:
  // The last `added` of the robots are on trial, too. Those that collide are left out.
  void complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                std::uint32_t near_pairs);

  const Rules& rules_;
  std::optional<RatedSet> set_;
  bool completed_ = false;
  std::size_t kept_ = 0;
  RatedSet offered_;  // its memory is used again and again
};

}  // namespace evenlift::balanced
