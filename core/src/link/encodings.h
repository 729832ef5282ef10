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

// Returns at least one encoding, and several for a small polygon. It compares only integers, so
// every platform chooses the same. O(n).
std::vector<QuantizedPolygon> likely_encodings(const Points& vertices);

}  // namespace evenlift
