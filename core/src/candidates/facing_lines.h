// The pairs of lines that face each other across C, for lines that need not form an outline.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "candidates/stand_lines.h"

namespace evenlift {

// Calls visit(i, j) for each two lines that face each other: in some open range of directions u,
// the ray from C along u meets line i and the ray along -u meets line j. Lines within `near` of C
// are left out. `visit` returns whether to continue. O(m log m + K) for m lines and K pairs.
void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit);

}  // namespace evenlift
