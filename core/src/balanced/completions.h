// The sets that complete given robots so that the centroid of all is C.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// The midpoint of two more robots that make C the centroid of all.
Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// The even candidates whose two ends, together with the robots, have the centroid C. If the outline
// has more than 1,000 vertices and there are many, only some of them (EvenChords::some_about).
std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots);

// All such candidates, for any outline.
std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots);

// Keeps the best of the offered sets; the first wins a tie.
class Best {
 public:
  explicit Best(const Rules& rules) : rules_(rules) {}

  // Makes a set the best so far, without comparing it.
  void offer(const RatedSet& set) { set_ = set; }
  // These two offer each completion of the robots by two or three more, in the order of the trial
  // points and candidates.
  void offer_two_more(const std::vector<LiftingPoint>& robots);
  void offer_three_more(const std::vector<LiftingPoint>& robots);
  // Offers the robots completed by three more, the first at `place`.
  void offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place);

  const std::optional<RatedSet>& set() const { return set_; }
  // Whether a completion has become the best set.
  bool completed() const { return completed_; }
  // The number of robots that the best set had before its completion. They come first in it.
  std::size_t kept() const { return kept_; }

 private:
  // Offers the robots with the ends of each even candidate that completes them, but skips colliding
  // sets. The last `added` robots do not count as kept.
  void complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                std::uint32_t near_pairs);

  const Rules& rules_;
  std::optional<RatedSet> set_;
  bool completed_ = false;
  std::size_t kept_ = 0;
  RatedSet offered_;  // a member so that its memory is reused
};

}  // namespace evenlift::balanced
