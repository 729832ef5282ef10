// Completes given robots by two or three more, so that the centroid of all is C.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// The point where the midpoint of two more robots must be, so that the centroid of all is C.
Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// The even candidates whose two ends, together with the robots, have the centroid C; none if
// middle_of_two_more() is not strictly inside the convex hull of P. If the outline has more than
// 1,000 vertices and many such candidates, only some are returned (EvenChords::some_about). Adds the
// work to `steps` (BalancedWork in balanced.h).
std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots,
                                         std::uint64_t& steps);

// All such candidates, for any outline.
std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots);

// Keeps the best of the offered sets; of sets that tie, the first.
class Best {
 public:
  // After `most_steps`, no three more are offered: any set will do, and none if usable_sets() can
  // take its place.
  explicit Best(const Rules& rules, std::uint64_t most_steps = ~std::uint64_t{0})
      : rules_(rules), most_steps_(most_steps) {}

  // Makes `set` the best so far, without a comparison.
  void offer(const RatedSet& set) { set_ = set; }
  // Offer each completion of the robots by two or by three more, in the order of the trial points
  // and then of the candidates.
  void offer_two_more(const std::vector<LiftingPoint>& robots);
  void offer_three_more(const std::vector<LiftingPoint>& robots);
  // Offers each completion of the robots by three more, of which the first is at `place`.
  void offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place);

  const std::optional<RatedSet>& set() const { return set_; }
  // Whether a completion has become the best set.
  bool completed() const { return completed_; }
  // The number of robots that the best set had before two or three more completed it. In the set,
  // these robots come first.
  std::size_t kept() const { return kept_; }
  // The work so far, in steps of BalancedWork (balanced.h).
  std::uint64_t steps() const { return steps_; }

 private:
  // Offers the robots together with the ends of each even candidate that completes them, but skips
  // sets whose robots collide. The last `added` of the `robots` do not count as kept. `near_pairs`
  // counts the near pairs among the `robots`.
  void complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                std::uint32_t near_pairs);

  const Rules& rules_;
  std::uint64_t most_steps_;
  std::optional<RatedSet> set_;
  bool completed_ = false;
  std::size_t kept_ = 0;
  std::uint64_t steps_ = 0;
  RatedSet offered_;  // a member so that its memory is reused
};

}  // namespace evenlift::balanced
