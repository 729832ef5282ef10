// The sets that complete given robots so that the centroid of all is C.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// The midpoint of two more robots that make C the centroid of all.
Vec2 middle_of_two_more(const std::vector<LiftingPoint>& robots, const Vec2& centre);

// The even candidates whose two ends complete the robots to the centroid C; only some of many
// (EvenChords::some_about) if the outline has more than 1,000 vertices.
std::vector<Candidate> pairs_to_complete(const Rules& rules,
                                         const std::vector<LiftingPoint>& robots);

// All of them, for any outline.
std::vector<Candidate> all_pairs_to_complete(const Rules& rules,
                                             const std::vector<LiftingPoint>& robots);

// Keeps the best of the offered sets; the first wins a tie.
class Best {
 public:
  explicit Best(const Rules& rules) : rules_(rules) {}

  // Offers each completion of the robots by two or three more, in their order.
  void offer(const RatedSet& set) { set_ = set; }
  void offer_two_more(const std::vector<LiftingPoint>& robots);
  void offer_three_more(const std::vector<LiftingPoint>& robots);
  // Offers the robots completed by three more, the first at `place`.
  void offer_three_more(const std::vector<LiftingPoint>& robots, const LiftingPoint& place);

  const std::optional<RatedSet>& set() const { return set_; }
  bool completed() const { return completed_; }
  // The number of robots of the best set before its completion. They come first.
  std::size_t kept() const { return kept_; }

 private:
  // The last `added` robots are on trial, as are the two ends. Skips colliding sets.
  void complete(const std::vector<LiftingPoint>& robots, std::size_t added,
                std::uint32_t near_pairs);

  const Rules& rules_;
  std::optional<RatedSet> set_;
  bool completed_ = false;
  std::size_t kept_ = 0;
  RatedSet offered_;  // kept to reuse its memory
};

}  // namespace evenlift::balanced
