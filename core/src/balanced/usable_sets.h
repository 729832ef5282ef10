// Sets of robots with a size, for objects on which few sets fit. Completions may find none where
// the usable boundary is short. So this search first chooses the number of robots on each usable
// interval, if their centroid can be at C, then their places.
#pragma once

#include <cstddef>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// The best such sets, at most `most`, the best first; none for points or too many intervals. Robots
// on one interval stand symmetrically about their middle: as close together as possible, as far
// apart, or between. At most most_nodes choices of numbers are tried, from the first interval after
// v* on, so that the work is bounded and the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

}  // namespace evenlift::balanced
