#include "link/quantizer.h"

#include <cmath>

#include "exact/bits.h"

namespace evenlift {
namespace {

constexpr double limit = 0x1p51;
constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};

}  // namespace

std::optional<std::int64_t> Scale::number_of(double value) const {
  if (!decimal()) {
    const std::uint64_t size = to_bits(value) & ~sign_bit;
    if ((size & ((std::uint64_t{1} << zero_bits_) - 1)) != 0) return std::nullopt;
    const auto number = static_cast<std::int64_t>(size >> zero_bits_);
    return (to_bits(value) & sign_bit) != 0 ? ~number : number;
  }
  // If m exists, it differs from the exact value * 10^k by less than 1/4, and rounding moves the
  // product by less than 1/4.
  const double product = value * powers[kind_];
  if (!(std::fabs(product) < limit - 1)) return std::nullopt;
  const auto number = static_cast<std::int64_t>(product + (product < 0 ? -0.5 : 0.5));
  if (!same_bits(value_of(number), value)) return std::nullopt;
  return number;
}

double Scale::value_of(std::int64_t number) const {
  if (decimal()) return static_cast<double>(number) / powers[kind_];
  const std::uint64_t sign = number < 0 ? sign_bit : 0;
  const auto size = static_cast<std::uint64_t>(number < 0 ? ~number : number);
  return from_bits(sign | (size << zero_bits_));
}

int decimals_of(double value) {
  // If k decimals suffice, so do more, until the integer becomes too large. Testing the largest k
  // first rejects most values at once.
  int most = 0;
  while (most < Scale::most_decimals && std::fabs(value) * powers[most + 1] < limit - 1) ++most;
  if (!Scale(most).number_of(value)) return Scale::doubles;
  int k = 0;
  while (!Scale(k).number_of(value)) ++k;
  return k;
}

}  // namespace evenlift
