// Which ways of writing a polygon are worth a try. No part of the format: any way can be read.
#pragma once

#include <vector>

#include "link/quantized.h"

namespace evenlift {

// A way, and the vertices on its scale.
struct WrittenWay {
  Way way;
  Cells cells;
};

// At least one; several if the polygon is small. Decided in integers, so that every platform comes
// to the same. O(n).
std::vector<WrittenWay> likely_ways(const Points& vertices);

}  // namespace evenlift
