// The start of the search: sets of two, three and more robots, each built from smaller sets.
#pragma once

#include <optional>
#include <vector>

#include "balanced/completions.h"

namespace evenlift::balanced {

// A set with its keys and with its robots in order along the outline. `kept` holds the robots of
// the smaller set from which it was built, and `came` the others.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // whether it was built on usable intervals, not from a smaller set
};

// The sets S_0, S_1 ... S_m (algorithm.md, Balanced robots), by their number of robots; empty where
// a set does not exist. If S_m does not exist for robots with a size, the best set on usable
// intervals (usable_sets.h) takes its place.
using StartSets = std::vector<std::optional<StartSet>>;
StartSets start_sets(const Rules& rules);

// The start from which the search restarts after it ended with `now`; nothing if that does not pay.
//   - For robots with a size, it is one of the most_starts best sets on usable intervals: the one
//     whose swaps lead to the best result, if that is better than `now`.
//   - For more than four points that miss the first level of the goal hold, S_4 is chosen also
//     among all sets of one trial point with three more robots. This start is returned if its S_m
//     reaches a higher level. It helps with regular polygons, where the first start is symmetrical
//     about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now);

}  // namespace evenlift::balanced
