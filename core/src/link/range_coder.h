// An adaptive binary range coder (G. N. N. Martin, Range encoding: an algorithm for removing
// redundancy from a digitised message, 1979) with digits of six bits. It wastes less than one digit
// on a whole link. Programs that read links must follow docs/link-format.md, "Coder".
//
// Encoder and Decoder have the same members, which take the value to write and return the value
// read. An encoder returns the value that it takes; a decoder ignores that value. So one template
// with the coder as its parameter describes the format in both directions. For example,
//
//   settings.seed = code_integer(coder, settings.seed, 64);
//
// writes the seed with an Encoder, and reads it with a Decoder.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace evenlift {

using Digits = std::vector<std::uint8_t>;  // each 0 .. 63

// One adaptive binary decision. The more frequent value takes fewer bits.
struct BitModel {
  std::uint16_t count[2];   // how often false and true have occurred
  void update(bool value);  // counts one more value; O(1)
};

class Encoder {
 public:
  static constexpr bool decoding = false;

  // Codes one of `count` equally likely values 0 .. count - 1; 1 <= count <= 4096. Amortized O(1).
  std::uint32_t code_uniform(std::uint32_t value, std::uint32_t count);
  // Codes one bit by the model, and updates the model. Amortized O(1).
  bool code_bit(bool value, BitModel& model);
  bool failed() const { return false; }
  void fail() {}

  // Returns the fewest digits from which a decoder reads the values. The encoder is unusable
  // afterwards. Amortized O(1).
  Digits finish();

 private:
  void narrow(std::uint32_t offset, std::uint32_t range);
  void carry();

  std::uint32_t low_ = 0;  // the lower end of the range, less the part in digits_; below 2^30
  std::uint32_t range_ = std::uint32_t{1} << 30;
  Digits digits_;
};

class Decoder {
 public:
  static constexpr bool decoding = true;

  explicit Decoder(std::span<const std::uint8_t> digits);

  // After a failure these two functions return 0, so check failed() before using a value.
  std::uint32_t code_uniform(std::uint32_t, std::uint32_t count);
  bool code_bit(bool, BitModel& model);

  // Whether the digits end too early, or no encoder writes such digits.
  bool failed() const { return failed_; }
  void fail() { failed_ = true; }

 private:
  std::uint32_t next_digit();
  void narrow(std::uint32_t offset, std::uint32_t range);

  std::span<const std::uint8_t> digits_;
  std::size_t read_ = 0;
  std::uint32_t code_ = 0;  // the next digits as a number, less the encoder's low_; below range_
  std::uint32_t range_ = std::uint32_t{1} << 30;
  bool failed_ = false;
};

// --- Codes built from code_uniform() and code_bit(); all O(1)

// Codes the lowest `count` bits of `value`, 0 <= `count` <= 64.
template <class Coder>
std::uint64_t code_bits(Coder& coder, std::uint64_t value, int count) {
  std::uint64_t result = 0;
  while (count > 0) {
    const int part = count < 12 ? count : 12;
    count -= part;
    const auto piece = static_cast<std::uint32_t>((value >> count) & ((1u << part) - 1));
    result = (result << part) | coder.code_uniform(piece, std::uint32_t{1} << part);
  }
  return result;
}

// Codes a value from 0 to `greatest`, as if all values were about equally likely.
template <class Coder>
std::uint64_t code_up_to(Coder& coder, std::uint64_t value, std::uint64_t greatest) {
  const int width = static_cast<int>(std::bit_width(greatest));
  const int low = width > 12 ? width - 12 : 0;
  const auto count = static_cast<std::uint32_t>(greatest >> low) + 1;
  const std::uint64_t high = coder.code_uniform(static_cast<std::uint32_t>(value >> low), count);
  const std::uint64_t result = (high << low) | code_bits(coder, value, low);
  if (result > greatest) coder.fail();
  return result;
}

// Codes an integer below 2^widest: first its width, then the bits below its leading 1. This is an
// Elias code whose widths are equally likely.
template <class Coder>
std::uint64_t code_integer(Coder& coder, std::uint64_t value, int widest) {
  const auto width = static_cast<int>(coder.code_uniform(
      static_cast<std::uint32_t>(std::bit_width(value)), static_cast<std::uint32_t>(widest) + 1));
  if (width == 0) return 0;
  return (std::uint64_t{1} << (width - 1)) | code_bits(coder, value, width - 1);
}

}  // namespace evenlift
