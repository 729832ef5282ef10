// The range coder of share links: values to base-64 digits and back, with a fraction of a bit lost
// in all. docs/link-format.md, "Coder", describes it; a program that reads links must do the same.
//
// Encoder and Decoder have the same members, so that one function, a template over the coder,
// describes what is written and what is read: each member takes the value to write and returns the
// value read (the encoder returns what it was given, the decoder ignores what it is given).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace evenlift {

using Digits = std::vector<std::uint8_t>;  // each 0 .. 63

// How often a choice fell to false and to true so far: what is usual costs less.
struct Odds {
  std::uint16_t count[2];
  void learn(bool value);  // O(1)
};

class Encoder {
 public:
  static constexpr bool decoding = false;

  // value of 0 .. count - 1, all alike; 1 <= count <= 4096. O(1) amortized.
  std::uint32_t uniform(std::uint32_t value, std::uint32_t count);
  bool choice(bool value, Odds& odds);
  bool failed() const { return false; }
  void fail() {}

  // The digits, as few as can be read back; the encoder is used up. O(1) amortized.
  Digits finish();

 private:
  void narrow(std::uint32_t offset, std::uint32_t range);
  void carry();

  std::uint32_t low_ = 0;  // below 2^30: the digits that are still open
  std::uint32_t range_ = std::uint32_t{1} << 30;
  Digits digits_;
};

class Decoder {
 public:
  static constexpr bool decoding = true;

  explicit Decoder(std::span<const std::uint8_t> digits);

  // As the encoder's. After a failure zeros, for ever: check failed() before believing anything.
  std::uint32_t uniform(std::uint32_t, std::uint32_t count);
  bool choice(bool, Odds& odds);

  // Whether something was read that no encoder writes, or more than there is.
  bool failed() const { return failed_; }
  void fail() { failed_ = true; }

 private:
  std::uint32_t next_digit();
  void narrow(std::uint32_t offset, std::uint32_t range);

  std::span<const std::uint8_t> digits_;
  std::size_t read_ = 0;
  std::uint32_t code_ = 0;  // what the encoder's low_ must come to, less low_; below range_
  std::uint32_t range_ = std::uint32_t{1} << 30;
  bool failed_ = false;
};

// --- on top of either coder; all O(1)

// The lowest `count` bits of value, 0 .. 64 of them.
template <class Coder>
std::uint64_t code_bits(Coder& coder, std::uint64_t value, int count) {
  std::uint64_t result = 0;
  while (count > 0) {
    const int part = count < 12 ? count : 12;
    count -= part;
    const auto piece = static_cast<std::uint32_t>((value >> count) & ((1u << part) - 1));
    result = (result << part) | coder.uniform(piece, std::uint32_t{1} << part);
  }
  return result;
}

// value of 0 .. greatest, about alike.
template <class Coder>
std::uint64_t code_up_to(Coder& coder, std::uint64_t value, std::uint64_t greatest) {
  const int width = static_cast<int>(std::bit_width(greatest));
  const int low = width > 12 ? width - 12 : 0;
  const auto count = static_cast<std::uint32_t>(greatest >> low) + 1;
  const std::uint64_t high = coder.uniform(static_cast<std::uint32_t>(value >> low), count);
  const std::uint64_t result = (high << low) | code_bits(coder, value, low);
  if (result > greatest) coder.fail();
  return result;
}

// An integer below 2^widest: its width, then the bits below its leading one.
template <class Coder>
std::uint64_t code_integer(Coder& coder, std::uint64_t value, int widest) {
  const auto width = static_cast<int>(coder.uniform(
      static_cast<std::uint32_t>(std::bit_width(value)), static_cast<std::uint32_t>(widest) + 1));
  if (width == 0) return 0;
  return (std::uint64_t{1} << (width - 1)) | code_bits(coder, value, width - 1);
}

}  // namespace evenlift
