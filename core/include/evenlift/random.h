// Uniform random numbers, the same on every platform. The C++ standard fixes its engines but not
// its distributions, so this file has its own.
#pragma once

#include <cstdint>
#include <random>

namespace evenlift {

// A generator of random numbers. A generator is a value: copies continue independently. Never draw
// twice within the arguments of one call, because compilers evaluate them in different orders.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : engine_(seed) {}

  // A number in [0, 1): the upper 53 bits of one draw. O(1).
  double uniform() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

  // A whole number in 0 .. n - 1 for n > 0. To avoid bias, draws at or above the greatest multiple
  // of n up to 2^64 are discarded. Expected O(1).
  std::uint64_t below(std::uint64_t n) {
    const std::uint64_t rejected = (~std::uint64_t{0} % n + 1) % n;  // 2^64 mod n
    std::uint64_t draw = engine_();
    while (draw > ~std::uint64_t{0} - rejected) draw = engine_();
    return draw % n;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace evenlift
