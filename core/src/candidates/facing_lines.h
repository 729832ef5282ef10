// The pairs of lines that face each other across C. The lines need not form an outline.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "candidates/stand_lines.h"

namespace evenlift {

// Calls visit(i, j) for each pair of lines that face each other: for an open range of directions u,
// the ray from C along u meets line i and the ray from C along -u meets line j. Lines that pass
// within `near` of C are in no pair. `visit` returns whether to continue. O(m log m + K) for m
// lines and K pairs.
void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit);

}  // namespace evenlift
