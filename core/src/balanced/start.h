// The start of the search: sets of two, three and more robots, each built from smaller sets.
#pragma once

#include <optional>
#include <vector>

#include "balanced/completions.h"

namespace evenlift::balanced {

// A set with its keys, its robots in their order along the outline, and the robots from which it
// was built.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // on usable intervals (usable_sets.h), not built from a smaller set
};

// S_0, S_1 ... S_m, by their number of robots; nothing where no such set exists. If robots have a
// size and no S_m exists, S_m is the best set on usable intervals (usable_sets.h).
using StartSets = std::vector<std::optional<StartSet>>;
StartSets start_sets(const Rules& rules);

// The start from which the search restarts after it has ended with a set; nothing if a restart does
// not pay.
//   - Robots with a size: of most_starts sets on usable intervals, the set whose swaps lead
//     farthest, if they lead to a better set.
//   - Points with the goal hold that miss the first margin level: a start in which S_4 may also be
//     the best trial point with three more, if its S_m reaches a higher level. So they may hold a
//     regular polygon, whose first start is symmetrical about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now);

}  // namespace evenlift::balanced
