// Turns coordinates into integers without loss. The integers number the steps of a decimal grid, or
// the doubles in ascending order.
#pragma once

#include <cstdint>
#include <optional>

namespace evenlift {

// A scale gives doubles their numbers.
class Scale {
 public:
  static constexpr int most_decimals = 22;           // higher powers of 10 are not doubles
  static constexpr int doubles = most_decimals + 1;  // the kind that numbers the doubles

  // `kind` is the number of decimals, 0 .. most_decimals, or `doubles`. With `doubles`, a double
  // has a number only if its lowest `zero_bits` (0 .. 52) bits are 0. The number omits these bits.
  explicit Scale(int kind, int zero_bits = 0) : kind_(kind), zero_bits_(zero_bits) {}
  int kind() const { return kind_; }
  bool decimal() const { return kind_ != doubles; }
  int zero_bits() const { return zero_bits_; }

  // The number of a finite value; nullopt if it has none. With k decimals, the number is the only
  // integer m, |m| < 2^51, for which m / 10^k, rounded once, equals the value bit for bit; -0 has
  // no number. With `doubles`, the number is the bit pattern of the absolute value, complemented if
  // the value is negative. So numbers ascend with values, 0 has number 0, and -0 has -1. O(1).
  std::optional<std::int64_t> number_of(double value) const;

  // The inverse of number_of. Any number has a value, which may be infinite or NaN. O(1).
  double value_of(std::int64_t number) const;

 private:
  int kind_;
  int zero_bits_;
};

// The least k for which Scale(k) has a number for this finite value; Scale::doubles if there is no
// such k. O(1).
int decimals_of(double value);

}  // namespace evenlift
