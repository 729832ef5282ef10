// The steps of a trace that tell its story by themselves: the first thing that is shown to a
// learner, and what a printed page has.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/trace.h"

namespace evenlift {

// At most this many, whatever the polygon and however many teams.
inline constexpr std::uint32_t most_main_steps = 22;

// Numbers of steps, increasing; the first is the polygon, the last the result. Of what is done
// again and again one example stands for all: the first ray; of the first 200 pairs of edges that
// led to a candidate the one with the longest sections, so that they can be seen (if none did, the
// first pair; without any pair, the first opposite vertices); the first range; the scores and
// choices of the first three teams, then the last team and the base that it completes; the first
// three exchanges of teams; of balanced robots the last set of the start, and the three exchanges
// that widen the coverage the most. What is done once is in the list, except the centroid, radial
// edges, duplicates, the search for a direction to slide, and the contacts of balanced robots.
// O(pairs), and with balanced robots balanced_keys() for each exchange.
std::vector<std::uint32_t> main_steps(const Trace& trace);

// How many steps of the kind of a main step there are besides those in the list: of `ray` and
// `outcome` the other rays and pairs, of `range` the other ranges, of `team` those between the
// third and the last, of `start` the smaller sets, of `swap` and `exchange` all others, with the
// last of the list. 0 for other kinds. O(1), and of `exchange` as main_steps().
std::uint32_t further_like(const Trace& trace, const Step& step);

}  // namespace evenlift
