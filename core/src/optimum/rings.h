// The rings of ends with the greatest coverage (optimum.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/optimum.h"
#include "optimum/triangles.h"

namespace evenlift::optimum {

// Ends in their order about C.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;
};

// The best ring of at most `most` ends of any chords. O(K^3 most), calling `stop` for each possible
// first end; nullopt if `stop` returned true.
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// The best ring of ends of at most `teams` chords that contains both ends of at least one chord. If
// no ring contains both ends of a chord, best_ring() with `teams` ends finds the best one. O(K^4
// teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// A ring whose share is at least that of best_ring_of_chords(): each side of a chord has up to
// teams - 1 separate ends. O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
