// Exact arithmetic on dyadic rationals m 2^e, which is what doubles are: the slow, always right end
// of the predicates. Closed under + - x; no division.
#pragma once

#include <cstdint>
#include <vector>

namespace evenlift {

class Dyadic {
 public:
  Dyadic() = default;
  explicit Dyadic(double value);  // finite

  int sign() const { return sign_; }

  // The nearest double up to a relative error of 2^-52; the sign is kept: a value below the
  // smallest double gives that, one beyond the largest gives the largest.
  double to_double() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  // a / b for b other than 0, up to a relative error of 2^-50 (and the rounding of a subnormal
  // result), also where a or b is beyond the range of doubles.
  friend double approximate_quotient(const Dyadic& a, const Dyadic& b);
  Dyadic operator-() const;

 private:
  using Limbs = std::vector<std::uint32_t>;  // magnitude, least significant first, no leading zeros
  // The magnitude as a double in [1, 2^96) times a power of two. Not for 0.
  struct Scaled {
    double value;
    std::int64_t exponent;
  };
  Scaled scaled() const;
  void normalize();
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_of_b);

  int sign_ = 0;
  std::int64_t exponent_ = 0;  // of the lowest limb, a multiple of 32
  Limbs limbs_;
};

}  // namespace evenlift
