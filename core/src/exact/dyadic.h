// Exact arithmetic on dyadic rationals, the numbers m 2^e with whole m and e, which include all
// finite doubles. It is the last and slowest stage of the predicates. Sums, differences and
// products of dyadic rationals are dyadic rationals, but quotients may not be.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace evenlift {

class Dyadic {
 public:
  Dyadic() = default;
  explicit Dyadic(double value);  // the value must be finite

  int sign() const { return sign_; }

  // The number as a double with the same sign (0 for 0). The relative error is at most 2^-52 unless
  // the result is subnormal. A number too large or too small for a double becomes the nearest
  // finite double of its sign that is not 0.
  double to_double() const;

  friend Dyadic operator+(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator-(const Dyadic& a, const Dyadic& b);
  friend Dyadic operator*(const Dyadic& a, const Dyadic& b);
  // The quotient a / b with a relative error of at most 2^-50, plus the rounding of a subnormal
  // result. b must not be 0. Both a and b may be beyond the range of doubles.
  friend double approximate_quotient(const Dyadic& a, const Dyadic& b);
  Dyadic operator-() const;

 private:
  // The digits of a magnitude, lowest first, without leading zeros. A few are stored in place,
  // since allocating memory would take most of the time.
  class Limbs {
   public:
    Limbs() = default;
    explicit Limbs(std::size_t size);  // all 0

    std::size_t size() const { return size_; }
    std::uint32_t operator[](std::size_t i) const { return digits()[i]; }
    std::uint32_t& operator[](std::size_t i) { return many_.empty() ? few_[i] : many_[i]; }
    void drop_leading_zeros();
    void drop_lowest(std::size_t number);

   private:
    const std::uint32_t* digits() const { return many_.empty() ? few_.data() : many_.data(); }

    std::array<std::uint32_t, 16> few_{};
    std::vector<std::uint32_t> many_;  // all digits if `few_` is too small, otherwise empty
    std::size_t size_ = 0;
  };
  class Aligned;
  // A magnitude above 0 as value 2^exponent, with the value in [1, 2^96).
  struct Scaled {
    double value;
    std::int64_t exponent;
  };
  Scaled scaled() const;
  void normalize();
  static int compare_magnitudes(const Aligned& a, const Aligned& b);
  static Limbs sum_of_magnitudes(const Aligned& a, const Aligned& b);
  static Limbs difference_of_magnitudes(const Aligned& a, const Aligned& b);
  static Limbs product_of_magnitudes(const Limbs& a, const Limbs& b);
  static Dyadic sum(const Dyadic& a, const Dyadic& b, int sign_of_b);

  int sign_ = 0;
  std::int64_t exponent_ = 0;  // of the lowest limb; a multiple of 32
  Limbs limbs_;
};

}  // namespace evenlift
