#include "link/range_coder.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include "exact/pseudo_angle.h"
#include "link/quantizer.h"

namespace evenlift {
namespace {

constexpr std::uint32_t whole = std::uint32_t{1} << 30;         // five digits
constexpr std::uint32_t narrow_limit = std::uint32_t{1} << 24;  // at or below it, emit a digit
constexpr std::uint32_t top_unit = std::uint32_t{1} << 24;      // one unit of the first digit

std::uint32_t false_part(std::uint32_t range, const BitModel& model) {
  return range / (std::uint32_t{model.count[0]} + model.count[1]) * model.count[0];
}

}  // namespace

void BitModel::update(bool value) {
  count[value ? 1 : 0] = static_cast<std::uint16_t>(count[value ? 1 : 0] + 2);
  if (count[0] + count[1] > 255) {
    count[0] = static_cast<std::uint16_t>((count[0] + 1) / 2);
    count[1] = static_cast<std::uint16_t>((count[1] + 1) / 2);
  }
}

std::uint32_t Encoder::code_uniform(std::uint32_t value, std::uint32_t count) {
  assert(count >= 1 && count <= 4096 && value < count);
  const std::uint32_t unit = range_ / count;
  narrow(unit * value, unit);
  return value;
}

bool Encoder::code_bit(bool value, BitModel& model) {
  const std::uint32_t part = false_part(range_, model);
  model.update(value);
  if (value) {
    narrow(part, range_ - part);
  } else {
    narrow(0, part);
  }
  return value;
}

void Encoder::narrow(std::uint32_t offset, std::uint32_t range) {
  low_ += offset;
  range_ = range;
  if (low_ >= whole) carry();
  while (range_ <= narrow_limit) {
    digits_.push_back(static_cast<std::uint8_t>(low_ / top_unit));
    low_ = low_ % top_unit * 64;
    range_ *= 64;
  }
}

// Adds one to the digits written. As a fraction they stay below 1, so one of them is below 63.
void Encoder::carry() {
  low_ -= whole;
  std::size_t i = digits_.size();
  while (digits_[--i] == 63) digits_[i] = 0;
  ++digits_[i];
}

Digits Encoder::finish() {
  // Finds the number in [low_, low_ + range_) with the fewest digits, since the decoder reads
  // missing digits as 0.
  std::uint32_t unit = whole;
  std::uint32_t value = (low_ + unit - 1) / unit * unit;
  int count = 0;
  while (value - low_ >= range_) {
    unit /= 64;
    value = (low_ + unit - 1) / unit * unit;
    ++count;
  }
  low_ = value;
  if (low_ >= whole) carry();
  for (; count > 0; --count) {
    digits_.push_back(static_cast<std::uint8_t>(low_ / top_unit));
    low_ = low_ % top_unit * 64;
  }
  return std::move(digits_);
}

Decoder::Decoder(std::span<const std::uint8_t> digits) : digits_(digits) {
  for (int i = 0; i < 5; ++i) code_ = code_ * 64 + next_digit();
}

std::uint32_t Decoder::next_digit() {
  const std::size_t at = read_++;
  if (at < digits_.size()) return digits_[at];
  if (at >= digits_.size() + 5) failed_ = true;  // an encoder omits at most five
  return 0;
}

std::uint32_t Decoder::code_uniform(std::uint32_t, std::uint32_t count) {
  if (failed_) return 0;
  const std::uint32_t unit = range_ / count;
  const std::uint32_t value = code_ / unit;
  if (value >= count) {  // the remainder of the division: no encoder uses it
    failed_ = true;
    return 0;
  }
  narrow(unit * value, unit);
  return value;
}

bool Decoder::code_bit(bool, BitModel& model) {
  if (failed_) return false;
  const std::uint32_t part = false_part(range_, model);
  const bool value = code_ >= part;
  model.update(value);
  if (value) {
    narrow(part, range_ - part);
  } else {
    narrow(0, part);
  }
  return value;
}

void Decoder::narrow(std::uint32_t offset, std::uint32_t range) {
  code_ -= offset;
  range_ = range;
  while (range_ <= narrow_limit) {
    code_ = code_ * 64 + next_digit();
    range_ *= 64;
  }
}

QuantizedVertices quantize(const Scale& scale, const Points& vertices) {
  QuantizedVertices quantized(vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const double value = vertices[i][axis];
      const auto number = scale.number_of(value);
      quantized[i][axis] = {value, number.value_or(0), !number};
    }
  }
  return quantized;
}

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

namespace {

// Trailing bits that are 0 in every coordinate.
int common_zero_bits(const Points& vertices) {
  std::uint64_t any = std::uint64_t{1} << 52;
  for (const Vec2& vertex : vertices) any |= to_bits(vertex.x) | to_bits(vertex.y);
  int zeros = 0;
  while ((any >> zeros & 1) == 0) ++zeros;
  return zeros;
}

// At most two scales that promise the shortest link.
std::vector<Scale> likely_scales(const Points& vertices) {
  std::array<std::size_t, Scale::doubles + 1> with_decimals{};
  double greatest = 1;
  for (const Vec2& vertex : vertices) {
    for (const double value : {vertex.x, vertex.y}) {
      ++with_decimals[static_cast<std::size_t>(decimals_of(value))];
      greatest = std::max(greatest, std::fabs(value));
    }
  }
  const std::size_t all = 2 * vertices.size();
  const auto integer_bits =
      static_cast<int>(std::bit_width(static_cast<std::uint64_t>(std::min(greatest, 0x1p62))));

  const int zero_bits = common_zero_bits(vertices);
  const std::size_t bits_of_doubles = all * static_cast<std::size_t>(56 - zero_bits);
  int decimals = 0;
  std::size_t bits_of_decimals = std::numeric_limits<std::size_t>::max();
  std::size_t on_scale = 0;
  for (int k = 0; k <= Scale::most_decimals; ++k) {
    if (with_decimals[static_cast<std::size_t>(k)] == 0) continue;
    on_scale += with_decimals[static_cast<std::size_t>(k)];
    const auto bits_each =
        static_cast<std::size_t>(integer_bits + (k * 10 + 2) / 3);  // 2^10 is about 10^3
    const std::size_t bits = on_scale * bits_each + (all - on_scale) * 68;
    if (bits < bits_of_decimals) {
      bits_of_decimals = bits;
      decimals = k;
    }
  }
  std::vector<Scale> scales;
  if (on_scale > 0 && bits_of_decimals / 5 <= bits_of_doubles / 4) scales.emplace_back(decimals);
  if (on_scale == 0 || bits_of_doubles / 5 <= bits_of_decimals / 4) {
    scales.emplace_back(Scale::doubles, zero_bits);
  }
  return scales;
}

std::uint64_t estimated_bits(const Encoding& encoding, const QuantizedVertices& quantized) {
  const bool plain_doubles = !encoding.scale.decimal() && encoding.predictor == Predictor::nothing;
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < quantized.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const QuantizedCoordinate& coordinate = quantized[i][axis];
      if (coordinate.escaped) {
        bits += 66;
      } else if (plain_doubles) {
        bits += static_cast<std::uint64_t>(54 - encoding.scale.zero_bits());
      } else {
        const std::uint64_t residual = static_cast<std::uint64_t>(coordinate.number) -
                                       predict(encoding.predictor, quantized, i, axis);
        const std::uint64_t size = (residual >> 63) != 0 ? 0 - residual : residual;
        bits += static_cast<std::uint64_t>(std::bit_width(size)) + 1;
      }
    }
  }
  return bits;
}

}  // namespace

std::vector<QuantizedPolygon> likely_encodings(const Points& vertices) {
  std::vector<QuantizedPolygon> encodings;
  std::uint64_t fewest_bits = 0;
  for (const Scale& scale : likely_scales(vertices)) {
    const QuantizedVertices quantized = quantize(scale, vertices);
    for (const Predictor predictor : all_predictors) {
      const Encoding encoding{scale, predictor};
      // The estimate is good enough for many vertices. For few, there is time to try all.
      if (vertices.size() <= 128) {
        encodings.push_back({encoding, quantized});
        continue;
      }
      const std::uint64_t bits = estimated_bits(encoding, quantized);
      if (encodings.empty() || bits < fewest_bits) {
        encodings.assign(1, {encoding, quantized});
        fewest_bits = bits;
      }
    }
  }
  return encodings;
}

}  // namespace evenlift
