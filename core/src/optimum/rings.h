// The best rings of ends (optimum.h).
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/optimum.h"
#include "optimum/triangles.h"

namespace evenlift::optimum {

// Ends in order about C.
struct Ring {
  double share = 0;
  std::vector<std::uint32_t> ends;
};

// Of at most `most` ends of any chords. O(K^3 most); calls `stop` for each possible first end;
// nullopt if it returned true.
std::optional<Ring> best_ring(const Triangles& triangles, std::uint32_t most, const Stop& stop);

// Of ends of at most `teams` chords, with both ends of at least one. If no ring has both ends of a
// chord, best_ring() with `teams` ends finds the best. O(K^4 teams).
std::optional<Ring> best_ring_of_chords(const Triangles& triangles, std::uint32_t teams,
                                        const Stop& stop);

// A ring whose share is at least that of best_ring_of_chords(): each side of a chord has up to teams - 1 separate ends.
// O(K^3 teams).
std::optional<Ring> best_ring_by_sides(const Triangles& triangles, std::uint32_t teams,
                                       const Stop& stop);

}  // namespace evenlift::optimum
