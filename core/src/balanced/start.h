// The start of the search: sets of two, three and more robots, each made of smaller ones.
#pragma once

#include <optional>
#include <vector>

#include "balanced/completions.h"

namespace evenlift::balanced {

// A set with its keys, its robots in their order along the outline, and of which robots it was made.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
};

// S_0, S_1 ... S_m, by their number of robots; nothing where there is no such set.
std::vector<std::optional<StartSet>> start_sets(const Rules& rules);

}  // namespace evenlift::balanced
