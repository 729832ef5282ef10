// The main steps of a trace, which suffice to follow the algorithm. A learner sees them first, and
// a printed page contains only these.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// For any polygon and any number of teams.
inline constexpr std::uint32_t most_main_steps = 25;

// Step numbers, increasing, from the polygon to the result. Of repeated steps, only these are
// included:
// - the first ray;
// - of the first 200 edge pairs that led to a candidate, the one with the longest sections, which
//   are easy to see (if none did, the first pair; without any pair, the first opposite vertices);
// - the first range;
// - the first three items of cargo, and the first four supports;
// - the scores and choices of the first three teams, then the last team and its lifting base;
// - the first three swaps of teams;
// - for balanced robots, the last set of the start, and the three swaps that widen the coverage
//   most.
// Steps that occur once are included, except the centroid, radial edges, duplicates, the search for
// a direction to slide, and the contacts of balanced robots. O(pairs), plus balanced_keys() for
// each swap of balanced robots.
std::vector<std::uint32_t> main_steps(const Trace& trace);

// The number of steps like this main step that main_steps() omits. For `ray`, `outcome` and
// `range`, all others; for the third `cargo`, all later items; for the third `team`, the teams
// between it and the last; for `start`, the smaller sets; for the last included `swap` or
// `exchange`, all omitted swaps; 0 for any other step. O(1); for `exchange` the cost of
// main_steps().
std::uint32_t further_like(const Trace& trace, const Step& step);

}  // namespace evenlift
