// Encodings of a polygon that are worth trying. The choice is not part of the format: readers
// accept every encoding.
#pragma once

#include <vector>

#include "link/quantized.h"

namespace evenlift {

struct QuantizedPolygon {
  Encoding encoding;
  QuantizedVertices quantized;
};

// Returns at least one encoding, and several for a small polygon. The choice depends only on
// integers, so every platform makes the same one. O(n).
std::vector<QuantizedPolygon> likely_encodings(const Points& vertices);

}  // namespace evenlift
