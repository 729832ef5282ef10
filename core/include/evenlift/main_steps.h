// The main steps of a trace, which suffice to follow the algorithm. A learner sees them first, and
// a printed page contains only these.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// The most steps that main_steps() returns, for any polygon and any number of teams.
inline constexpr std::uint32_t most_main_steps = 25;

// Returns the numbers of the main steps in order, from the polygon to the result. If a kind of step
// occurs repeatedly, only these are included:
// - the first ray;
// - among the first 200 edge pairs that led to a candidate, the pair with the longest sections,
//   which are easy to see (the first pair if no pair led to a candidate; the first opposite
//   vertices if there are no pairs);
// - the first range;
// - the first three items of cargo, and the first four supports;
// - the scores and choices of the first three teams, then the choice of the last team and the
//   lifting base after it;
// - the first three swaps of teams;
// - for balanced robots, the last `start`, and the three swaps that increase the coverage most.
// Steps that occur only once are included, except the centroid, radial edges, duplicates, the
// search for a direction to slide, and the contacts of balanced robots. O(pairs), plus the cost of
// balanced_keys() for each swap of balanced robots.
std::vector<std::uint32_t> main_steps(const Trace& trace);

// Returns the number of omitted steps for which this main step stands. For `ray`, `outcome` and
// `range` these are all others of the kind; for the third `cargo`, all later items; for the third
// `team`, the teams between it and the last; for `start`, the smaller sets; and for the third
// `swap` of teams or the last included `exchange` (swap of balanced robots), all omitted swaps. For
// any other step the number is 0. O(1); for `exchange` the cost of main_steps().
std::uint32_t further_like(const Trace& trace, const Step& step);

}  // namespace evenlift
