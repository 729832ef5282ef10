// The three robots that a swap may replace.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift::balanced {

using Triple = std::array<std::uint32_t, 3>;  // increasing

// The triples that may be swapped, in lexicographic order. Up to 12 robots, these are all triples;
// up to 24, those with two neighbours along the outline; beyond, those of three in a row. O(m^3).
std::vector<Triple> triples_of(std::uint32_t robots);

// The robots outside the triple. O(m).
std::vector<LiftingPoint> others(const std::vector<LiftingPoint>& robots, const Triple& triple);

}  // namespace evenlift::balanced
