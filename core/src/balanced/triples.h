// The three robots that a swap may replace.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "evenlift/chords.h"

namespace evenlift::balanced {

using Triple = std::array<std::uint32_t, 3>;  // increasing

// The triples that a swap may replace, in lexicographic order. For up to 12 robots, these are all
// triples; for up to 24, the triples that contain two neighbours along the outline; for more, the
// triples of three robots in a row. O(m^3).
std::vector<Triple> triples_of(std::uint32_t robots);

// The robots outside the triple. O(m).
std::vector<LiftingPoint> others(const std::vector<LiftingPoint>& robots, const Triple& triple);

}  // namespace evenlift::balanced
