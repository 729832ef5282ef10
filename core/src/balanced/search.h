// The start of the search: sets of two, three and more robots, each built from smaller sets.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "balanced/rules.h"
#include "evenlift/balanced.h"

namespace evenlift::balanced {

// A set with its keys and with its robots in order along the outline. If the set was built from a
// smaller set, `kept` holds the robots of the smaller set, and `came` the others.
struct StartSet {
  RatedSet set;
  std::vector<LiftingPoint> kept, came;
  bool at_once = false;  // whether the set is from usable_sets(); then `came` holds all robots
};

// The sets S_0, S_1 ... S_m (algorithm.md, Balanced robots), indexed by their number of robots; an
// entry is empty if its set does not exist. If S_m does not exist and robots cannot stand
// everywhere, the best set on usable intervals (usable_sets.h) takes the place of S_m.
using StartSets = std::vector<std::optional<StartSet>>;
// `cut_short` becomes whether most_start_steps (balanced.h) are spent; the remaining sets are then
// chosen among few.
StartSets start_sets(const Rules& rules, bool* cut_short = nullptr);

// The start from which the search begins again after it ended with `now`; nothing if no better
// start is found. The steps that it takes add to `work`; if this reaches the limit, the result is
// incomplete.
//   - If robots have a size or there are no-go parts, the swaps are tried from each of the best
//     sets on usable intervals, at most most_starts of them. If the best result is better than
//     `now`, the returned list contains only the set that leads to it.
//   - Otherwise, if there are more than four robots, the goal is `hold` and `now` has level 0, the
//     sets S_i are built again. The choice of S_4 then includes all sets that consist of a trial
//     point and three more robots. The new sets are returned if S_m has a higher level than `now`.
//     This helps with regular polygons, where the first start is symmetrical about C.
inline constexpr std::size_t most_starts = 6;
std::optional<StartSets> second_start(const Rules& rules, const std::vector<LiftingPoint>& now,
                                      BalancedWork& work);

// --- Sets of robots with a size, for objects on which few sets fit. If the usable boundary is short,
// completing smaller sets (completions.h) may find no set. So this search first chooses the number
// of robots on each usable interval such that the centroid of all can be at C, and then the places
// of the robots.

// Returns up to `most` of the best such sets, the best first; none if robots are points that may
// stand anywhere. The robots on one interval stand at equal distances, as close together as
// possible, as far apart as possible, or in between. The search chooses the numbers of robots one
// interval after another along the outline, from v*, the vertex farthest from C, on. It makes at
// most most_nodes partial choices, so that the work is bounded and the same on every platform.
inline constexpr std::size_t most_nodes = 100'000;
std::vector<RatedSet> usable_sets(const Rules& rules, std::size_t most);

// --- The swaps of the search for balanced robots. evenlift/balanced.h explains the two functions;
// there they take a BalancedProblem, here its Rules.

BalancedStep try_next_triple(const Rules& rules, BalancedSearch search);
BalancedSearch finish_search(const Rules& rules, BalancedSearch search);

}  // namespace evenlift::balanced
