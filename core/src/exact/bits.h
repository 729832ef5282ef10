// Converts doubles to their bits and back, without std::bit_cast, which older versions of
// Emscripten lack.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>

namespace evenlift {

static_assert(std::numeric_limits<double>::is_iec559 && sizeof(double) == 8);

inline std::uint64_t to_bits(double value) {
  std::uint64_t bits;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

inline double from_bits(std::uint64_t bits) {
  double value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

// Whether all bits of a and b are equal. So -0 and 0 differ. O(1).
inline bool same_bits(double a, double b) { return to_bits(a) == to_bits(b); }

}  // namespace evenlift
