// The pairs of lines that face each other across C, for lines that need not be the outline of
// anything.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "candidates/stand_lines.h"

namespace evenlift {

// Calls visit(i, j) for each two lines for which some open range of directions u has the ray from C
// along u meet line i and the ray along -u meet line j. Lines within `near` of C are left out. The
// visit says whether to go on. O(m log m + K) for m lines and K pairs.
void for_each_facing(const std::vector<StandLine>& lines, double near,
                     const std::function<bool(std::uint32_t i, std::uint32_t j)>& visit);

}  // namespace evenlift
