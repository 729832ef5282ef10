// Uniform draws that are the same on every platform: standard engines are, standard distributions
// are not.
#pragma once

#include <cstdint>
#include <random>

namespace evenlift {

// A value: copies continue independently. Never draw twice in one function call's arguments, whose
// order of evaluation differs between compilers.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [0, 1): the upper 53 bits of one draw. O(1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // Uniform in 0 .. n - 1, n > 0, without bias: draws beyond the last whole multiple of n are
  // drawn again. Expected O(1).
  std::uint64_t below(std::uint64_t n) {
    const std::uint64_t excess = (~std::uint64_t{0} % n + 1) % n;  // 2^64 mod n
    std::uint64_t draw = engine_();
    while (draw > ~std::uint64_t{0} - excess) draw = engine_();
    return draw % n;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace evenlift
