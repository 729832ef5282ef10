// Exact arithmetic on dyadic rationals m 2^e, which include all finite doubles: the last and slow
// stage of the predicates. They are closed under + - x but not under division.
#pragma once

#include <cstdint>
#include <vector>

namespace evenlift {

class Dyadic {
 public:
  Dyadic() = default;
  explicit Dyadic(double value);  // the value must be finite

  int sign() const { return sign_; }

  // The number as a double: 0 for 0, otherwise a double with the same sign and a relative error of
  // at most 2^-52. A number beyond the range of doubles becomes the nearest one that is not 0.
  double to_double() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  // The quotient a / b with a relative error of at most 2^-50, plus the rounding of a subnormal
  // result. b must not be 0. Both a and b may be beyond the range of doubles.
  friend double approximate_quotient(const Dyadic& a, const Dyadic& b);
  Dyadic operator-() const;

 private:
  using Limbs = std::vector<std::uint32_t>;  // magnitude, least significant first, no leading zeros
  // The magnitude, not 0, as a double in [1, 2^96) times a power of two.
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
