// Sets of robots with a size where few of them find a place. The search among completions walks
// from set to set, and where the boundary that can be used is short it may meet none. So these sets
// are found the other way round: first how many robots each usable interval takes, which can have
// their centroid at C at all, and then their places.
#pragma once

#include <cstddef>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// The best sets of that kind, at most `most`, the best first; none where robots are points or where
// there are too many intervals. Robots on one interval stand symmetrically about their middle, as
// near to each other as they can, as far apart as they can, or between. At most most_nodes choices
// of numbers are looked at, from the first interval behind v* on, so that the work is bounded and
// the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

}  // namespace evenlift::balanced
