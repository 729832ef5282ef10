// Exact arithmetic on dyadic rationals m 2^e, which include all finite doubles. It is the last,
// slow and exact stage of the predicates. Dyadic rationals are closed under + - x but not under
// division.
#pragma once

#include <cstdint>
#include <vector>

namespace evenlift {

class Dyadic {
 public:
  Dyadic() = default;
  explicit Dyadic(double value);  // finite

  int sign() const { return sign_; }

  // A double with the same sign and a relative error of at most 2^-52. Values below the smallest
  // positive double give that double, and values beyond the largest give the largest.
  double to_double() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  // a / b for b other than 0, with a relative error of at most 2^-50, plus the rounding of a
  // subnormal result. a and b may be beyond the range of doubles.
  friend double approximate_quotient(const Dyadic& a, const Dyadic& b);
  Dyadic operator-() const;

 private:
  using Limbs = std::vector<std::uint32_t>;  // magnitude, least significant first, no leading zeros
  // The magnitude as a double in [1, 2^96) times a power of two. The number must not be 0.
  struct Scaled {
    double value;
    std::int64_t exponent;
  };
  Scaled scaled() const;
  void normalize();
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_of_b);

  int sign_ = 0;
  std::int64_t exponent_ = 0;  // of the lowest limb; a multiple of 32
  Limbs limbs_;
};

}  // namespace evenlift
