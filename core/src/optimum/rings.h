// The best rings of ends (optimum.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/optimum.h"
#include "optimum/triangles.h"

namespace evenlift::optimum {

// Ends of chords in order about C, and the share of P that they cover.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;
};

// The best ring of at most `most` ends of any chords. It calls `stop` for each possible first end,
// and returns nullopt if `stop` returned true. O(K^3 most).
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// The best ring of ends of at most `teams` chords that has both ends of at least one chord. Among
// rings without both ends of any chord, best_ring() with `teams` ends finds the best. O(K^4 teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// A ring whose share is at least that of best_ring_of_chords(): on each side of a chord, up to
// teams - 1 ends are chosen separately. O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
