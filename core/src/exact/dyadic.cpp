#include "exact/dyadic.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "exact/sorted_indices.h"

namespace evenlift {
namespace {

// ldexp for any exponent; beyond the range of doubles the result is 0 or infinity.
double shifted(double value, std::int64_t exponent) {
  return std::ldexp(value, static_cast<int>(std::clamp<std::int64_t>(exponent, -5000, 5000)));
}

}  // namespace

Dyadic::Limbs::Limbs(std::size_t size) : size_(size) {
  if (size > few_.size()) many_.resize(size);
}

void Dyadic::Limbs::drop_leading_zeros() {
  const std::uint32_t* all = digits();
  while (size_ > 0 && all[size_ - 1] == 0) --size_;
}

void Dyadic::Limbs::drop_lowest(std::size_t number) {
  size_ -= number;
  for (std::size_t i = 0; i < size_; ++i) (*this)[i] = (*this)[i + number];
}

// A magnitude's digits, followed by zeros down to the exponent `lowest`.
class Dyadic::Aligned {
 public:
  Aligned(const Dyadic& of, std::int64_t lowest)
      : limbs_(of.limbs_), zeros_(static_cast<std::size_t>((of.exponent_ - lowest) / 32)) {}

  std::size_t size() const { return limbs_.size() + zeros_; }
  std::uint32_t operator[](std::size_t i) const {
    return i >= zeros_ && i < size() ? limbs_[i - zeros_] : 0;
  }

 private:
  const Limbs& limbs_;
  std::size_t zeros_;
};

int Dyadic::compare_magnitudes(const Aligned& a, const Aligned& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

Dyadic::Limbs Dyadic::sum_of_magnitudes(const Aligned& a, const Aligned& b) {
  Limbs result(std::max(a.size(), b.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    carry += std::uint64_t{a[i]} + b[i];
    result[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  return result;
}

// For a >= b.
Dyadic::Limbs Dyadic::difference_of_magnitudes(const Aligned& a, const Aligned& b) {
  Limbs result(a.size());
  std::int64_t borrow = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    const std::int64_t digit = std::int64_t{a[i]} - b[i] - borrow;
    borrow = digit < 0 ? 1 : 0;
    result[i] = static_cast<std::uint32_t>(digit + (borrow << 32));
  }
  return result;
}

Dyadic::Limbs Dyadic::product_of_magnitudes(const Limbs& a, const Limbs& b) {
  Limbs result(a.size() + b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::uint64_t carry = 0;
    for (std::size_t j = 0; j < b.size(); ++j) {
      carry += std::uint64_t{a[i]} * b[j] + result[i + j];
      result[i + j] = static_cast<std::uint32_t>(carry);
      carry >>= 32;
    }
    result[i + b.size()] = static_cast<std::uint32_t>(carry);
  }
  return result;
}

Dyadic::Dyadic(double value) {
  if (value == 0) return;
  sign_ = value < 0 ? -1 : 1;
  int exponent = 0;
  const double fraction = std::frexp(std::fabs(value), &exponent);
  const auto mantissa = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
  const int lowest = exponent - 53;
  const int shift = ((lowest % 32) + 32) % 32;
  exponent_ = lowest - shift;
  const std::uint64_t low = mantissa << shift;
  const std::uint64_t high = shift == 0 ? 0 : mantissa >> (64 - shift);
  limbs_ = Limbs(3);
  limbs_[0] = static_cast<std::uint32_t>(low);
  limbs_[1] = static_cast<std::uint32_t>(low >> 32);
  limbs_[2] = static_cast<std::uint32_t>(high);
  normalize();
}

void Dyadic::normalize() {
  limbs_.drop_leading_zeros();
  std::size_t zeros = 0;
  while (zeros < limbs_.size() && limbs_[zeros] == 0) ++zeros;
  if (zeros == 0) return;
  limbs_.drop_lowest(zeros);
  exponent_ += 32 * static_cast<std::int64_t>(zeros);
}

Dyadic::Scaled Dyadic::scaled() const {
  const std::size_t n = limbs_.size();
  const std::size_t used = std::min<std::size_t>(n, 3);  // at least 65 significant bits
  double value = 0;
  for (std::size_t i = 0; i < used; ++i) value = value * 4294967296.0 + limbs_[n - 1 - i];
  return {value, exponent_ + 32 * static_cast<std::int64_t>(n - used)};
}

double Dyadic::to_double() const {
  if (sign_ == 0) return 0;
  const Scaled top = scaled();
  double value = shifted(top.value, top.exponent);
  value = std::clamp(value, std::numeric_limits<double>::denorm_min(),
                     std::numeric_limits<double>::max());
  return sign_ < 0 ? -value : value;
}

Dyadic Dyadic::operator-() const {
  Dyadic result = *this;
  result.sign_ = -result.sign_;
  return result;
}

Dyadic Dyadic::sum(const Dyadic& a, const Dyadic& b, int sign_of_b) {
  if (b.sign_ == 0) return a;
  const int sign = b.sign_ * sign_of_b;
  if (a.sign_ == 0) return sign_of_b < 0 ? -b : b;
  Dyadic result;
  result.exponent_ = std::min(a.exponent_, b.exponent_);
  const Aligned first(a, result.exponent_), second(b, result.exponent_);
  if (a.sign_ == sign) {
    result.sign_ = sign;
    result.limbs_ = sum_of_magnitudes(first, second);
  } else {
    const int order = compare_magnitudes(first, second);
    if (order == 0) return Dyadic();
    result.sign_ = order > 0 ? a.sign_ : sign;
    result.limbs_ = order > 0 ? difference_of_magnitudes(first, second)
                              : difference_of_magnitudes(second, first);
  }
  result.normalize();
  return result;
}

Dyadic operator+(const Dyadic& a, const Dyadic& b) { return Dyadic::sum(a, b, 1); }
Dyadic operator-(const Dyadic& a, const Dyadic& b) { return Dyadic::sum(a, b, -1); }

double approximate_quotient(const Dyadic& a, const Dyadic& b) {
  if (a.sign_ == 0) return 0;
  const Dyadic::Scaled top = a.scaled(), bottom = b.scaled();
  return a.sign_ * b.sign_ * shifted(top.value / bottom.value, top.exponent - bottom.exponent);
}

Dyadic operator*(const Dyadic& a, const Dyadic& b) {
  Dyadic result;
  if (a.sign_ == 0 || b.sign_ == 0) return result;
  result.sign_ = a.sign_ * b.sign_;
  result.exponent_ = a.exponent_ + b.exponent_;
  result.limbs_ = Dyadic::product_of_magnitudes(a.limbs_, b.limbs_);
  result.normalize();
  return result;
}

SortedIndices indices_below(std::size_t n) {
  SortedIndices indices(n);
  std::iota(indices.begin(), indices.end(), std::uint32_t{0});
  return indices;
}

void sort_indices(std::span<std::uint32_t> indices, const void* order, IsBefore is_before) {
  std::stable_sort(indices.begin(), indices.end(),
                   [=](std::uint32_t i, std::uint32_t j) { return is_before(order, i, j); });
}

SortedIndices lexicographic_order(const Points& points) {
  return sorted_indices(points.size(), [&](std::uint32_t i, std::uint32_t j) {
    return lexicographically_before(points[i], points[j]);
  });
}

}  // namespace evenlift
