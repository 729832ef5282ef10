// Sets of robots with a size, for objects on which few sets fit. Completing smaller sets
// (completions.h) may find no set where the usable boundary is short. So this search first chooses
// how many robots stand on each usable interval, such that their centroid can be at C, and then
// their places.
#pragma once

#include <cstddef>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// Up to `most` of the best such sets, the best first; empty for points that may stand anywhere.
// Robots on one interval stand symmetrically about their middle: as close together as possible, as
// far apart as possible, or in between. At most most_nodes choices of numbers of robots are tried,
// from the first interval after v* on, so that the work is bounded and the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

}  // namespace evenlift::balanced
