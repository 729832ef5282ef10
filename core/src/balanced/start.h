// The start of the search: sets of two, three and more robots, each built from smaller sets.
#pragma once

#include <optional>
#include <vector>

#include "balanced/completions.h"

namespace evenlift::balanced {

// A set with its keys, its robots in order along the outline, and those from which it was built.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // not built from a smaller set, but on usable intervals
};

// S_0, S_1 ... S_m, by their number of robots; nothing where none exists. For robots with a size,
// S_m is then the best set on usable intervals (usable_sets.h).
using StartSets = std::vector<std::optional<StartSet>>;
StartSets start_sets(const Rules& rules);

// The start from which the search restarts after it ended with `now`; nothing if that does not pay.
//   - Robots with a size: of most_starts sets on usable intervals, the one whose swaps lead
//     farthest, if to a better set.
//   - Points with the goal hold that miss the first margin level: a start whose S_4 may also be the
//     best trial point with three more, if its S_m reaches a higher level. So they may hold a
//     regular polygon, whose first start is symmetrical about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now);

}  // namespace evenlift::balanced
