#include "link/range_coder.h"

#include <cassert>
#include <utility>

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

}  // namespace evenlift
