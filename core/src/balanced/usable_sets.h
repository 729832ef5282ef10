// Sets of robots with a size, for objects on which few sets fit. If the usable boundary is short,
// completing smaller sets (completions.h) may find no set. So this search first chooses the number
// of robots on each usable interval such that the centroid of all can be at C, and then the places
// of the robots.
#pragma once

#include <cstddef>
#include <vector>

#include "balanced/rules.h"

namespace evenlift::balanced {

// Returns up to `most` of the best such sets, the best first; none if robots are points that may
// stand anywhere. The robots on one interval stand at equal distances, as close together as
// possible, as far apart as possible, or in between. The search chooses the numbers of robots one
// interval after another along the outline, from v*, the vertex farthest from C, on. It makes at
// most most_nodes partial choices, so that the work is bounded and the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

}  // namespace evenlift::balanced
