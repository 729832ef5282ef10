#include "exact/dyadic.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace evenlift {
namespace {

using Limbs = std::vector<std::uint32_t>;

int compare_magnitude(const Limbs& a, const Limbs& b) {
  if (a.size() != b.size()) return a.size() < b.size() ? -1 : 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

void trim(Limbs& limbs) {
  while (!limbs.empty() && limbs.back() == 0) limbs.pop_back();
}

Limbs add_magnitude(const Limbs& a, const Limbs& b) {
  Limbs result(std::max(a.size(), b.size()) + 1);
  std::uint64_t carry = 0;
  for (std::size_t i = 0; i < result.size(); ++i) {
    carry += (i < a.size() ? a[i] : 0);
    carry += (i < b.size() ? b[i] : 0);
    result[i] = static_cast<std::uint32_t>(carry);
    carry >>= 32;
  }
  trim(result);
  return result;
}

// a - b for a >= b.
Limbs subtract_magnitude(const Limbs& a, const Limbs& b) {
  Limbs result(a.size());
  std::int64_t borrow = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::int64_t digit = std::int64_t{a[i]} - (i < b.size() ? b[i] : 0) - borrow;
    borrow = digit < 0 ? 1 : 0;
    result[i] = static_cast<std::uint32_t>(digit + (borrow << 32));
  }
  trim(result);
  return result;
}

Limbs multiply_magnitude(const Limbs& a, const Limbs& b) {
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
  trim(result);
  return result;
}

// ldexp for any exponent; beyond the range of doubles the result is 0 or infinity.
double shifted(double value, std::int64_t exponent) {
  return std::ldexp(value, static_cast<int>(std::clamp<std::int64_t>(exponent, -5000, 5000)));
}

}  // namespace

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
  limbs_ = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
            static_cast<std::uint32_t>(high)};
  normalize();
}

void Dyadic::normalize() {
  trim(limbs_);
  std::size_t zeros = 0;
  while (zeros < limbs_.size() && limbs_[zeros] == 0) ++zeros;
  if (zeros > 0) {
    limbs_.erase(limbs_.begin(), limbs_.begin() + static_cast<std::ptrdiff_t>(zeros));
    exponent_ += 32 * static_cast<std::int64_t>(zeros);
  }
  if (limbs_.empty()) *this = Dyadic();
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
  Dyadic second = b;
  second.sign_ *= sign_of_b;
  if (a.sign_ == 0) return second;
  Dyadic first = a;
  Dyadic& higher = first.exponent_ > second.exponent_ ? first : second;
  const std::int64_t lowest = std::min(first.exponent_, second.exponent_);
  higher.limbs_.insert(higher.limbs_.begin(),
                       static_cast<std::size_t>((higher.exponent_ - lowest) / 32), 0u);
  higher.exponent_ = lowest;

  Dyadic result;
  result.exponent_ = lowest;
  if (first.sign_ == second.sign_) {
    result.sign_ = first.sign_;
    result.limbs_ = add_magnitude(first.limbs_, second.limbs_);
  } else {
    const int order = compare_magnitude(first.limbs_, second.limbs_);
    if (order == 0) return Dyadic();
    result.sign_ = order > 0 ? first.sign_ : second.sign_;
    result.limbs_ = order > 0 ? subtract_magnitude(first.limbs_, second.limbs_)
                              : subtract_magnitude(second.limbs_, first.limbs_);
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
  result.limbs_ = multiply_magnitude(a.limbs_, b.limbs_);
  result.normalize();
  return result;
}

}  // namespace evenlift
