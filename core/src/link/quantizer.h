// Coordinates of share links as integers: on a decimal grid, or doubles in their order.
#pragma once

#include <cstdint>
#include <optional>

namespace evenlift {

// How doubles are numbered.
class Scale {
 public:
  static constexpr int most_decimals = 22;           // 10^22 is the last that is a double
  static constexpr int doubles = most_decimals + 1;  // every double has a number

  // 0 .. most_decimals, or doubles: then those whose lowest `zero_bits` are 0 have numbers, without
  // these bits; 0 .. 52.
  explicit Scale(int kind, int zero_bits = 0) : kind_(kind), zero_bits_(zero_bits) {}
  int kind() const { return kind_; }
  bool decimal() const { return kind_ != doubles; }
  int zero_bits() const { return zero_bits_; }

  // The number of the value, which is finite: of k decimals the integer m below 2^51 in size such
  // that m / 10^k, rounded once, is the value in every bit; none if there is none (nor for -0).
  // Below 2^51 there is no more than one. Of doubles, the size's bits, or their complement for a
  // negative value; so numbers rise with values, -0 has -1 and 0 has 0. O(1).
  std::optional<std::int64_t> number_of(double value) const;

  // The value with the number; the opposite of number_of where that gives one. Any number has a
  // value, perhaps not finite. O(1).
  double value_of(std::int64_t number) const;

 private:
  int kind_;
  int zero_bits_;
};

// The fewest decimals k for which Scale(k) has the finite value; Scale::doubles if none has. O(1).
int decimals_of(double value);

}  // namespace evenlift
