// The best rings of ends (algorithm.md, The optimum).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/optimum.h"
#include "optimum/triangles.h"

namespace evenlift::optimum {

// A ring's ends, and the share of P's area in the triangles of C with successive ends.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;  // in order about C, except from best_ring_by_sides()
};

// The best ring of at most `most` ends of any chords. All three functions call `stop` before each
// first end or first chord that they try, and return nullopt if it returns true. O(K^3 most).
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// The best ring that has both ends of some chord, and ends of at most `teams` chords. Any other
// ring of `teams` chords has at most `teams` ends, so best_ring() covers it. O(K^4 teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// A ring whose share is at least that of best_ring_of_chords(). It has both ends of one chord, and
// up to `teams` - 1 other ends on each side of this chord. The two sides together may use more than
// `teams` - 1 other chords. O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
