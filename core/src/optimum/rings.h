// The rings of ends that cover most (optimum.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/optimum.h"
#include "optimum/triangles.h"

namespace evenlift::optimum {

// Some ends in the order in which C sees them.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;
};

// The best ring of at most `most` ends, of whatever chords. O(K^3 most), asking `stop` for each end
// where the ring may begin; nothing if that was true.
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// The best ring of ends of at most `teams` chords that has both ends of one of them. Where no ring
// has both ends of a chord, best_ring() with as many ends finds the best one. O(K^4 teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// At least the share of best_ring_of_chords(): each side of a chord takes up to teams - 1 ends of
// its own. O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
