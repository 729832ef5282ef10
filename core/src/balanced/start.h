// The start of the search: sets of two, three and more robots, each made of smaller ones.
#pragma once

#include <optional>
#include <vector>

#include "balanced/completions.h"

namespace evenlift::balanced {

// A set with its keys, its robots in their order along the outline, and of which robots it was
// made.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // on usable intervals (usable_sets.h), not made of a smaller set
};

// S_0, S_1 ... S_m, by their number of robots; nothing where there is no such set. Where robots
// have a size and there is no S_m it is the best set on usable intervals (usable_sets.h).
using StartSets = std::vector<std::optional<StartSet>>;
StartSets start_sets(const Rules& rules);

// From where the search begins once more, when it has ended with a set; nothing if that is not
// worth while.
//   - Robots with a size begin with the one of most_starts sets on usable intervals whose exchanges lead
//     farthest, if they lead to a better set.
//   - Points that are to hold, and do not reach the first level, begin with a start in which S_4 is also the
//     best stand with three more, if its S_m is at a higher level. So they may hold a regular polygon, whose
//     first start is symmetrical about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now);

}  // namespace evenlift::balanced
