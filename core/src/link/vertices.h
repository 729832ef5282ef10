// The vertices in share links of version 1, for either coder: each coordinate as an integer of a
// scale, of which a guess from the vertices before is taken away, and the small rest is written
// with odds that follow what came before.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "exact/bits.h"
#include "link/quantized.h"
#include "link/range_coder.h"

namespace evenlift {

// What is left of a number after the guess, as a sign, a class of sizes, and the place in the
// class. Class 0 is 0 itself.
struct Rest {
  bool negative = false;
  unsigned size_class = 0;
  std::uint64_t place = 0;
};

// How rests are divided into classes.
class Classes {
 public:
  explicit Classes(const Way& way)
      : exponents_(!way.scale.decimal() && way.guess == Guess::nothing),
        fraction_bits_(52 - way.scale.zero_bits()) {}

  unsigned last() const { return exponents_ ? 2047 : 64; }

  // Bits of the place in a class above 0.
  int place_bits(unsigned size_class) const {
    return exponents_ ? fraction_bits_ : static_cast<int>(size_class) - 1;
  }

  // Class c holds the sizes with c bits; for doubles that are not guessed at, those with the
  // exponent c - 1.
  Rest rest_of(std::uint64_t number) const {
    Rest rest;
    rest.negative = (number >> 63) != 0;
    if (number == 0) return rest;
    if (exponents_) {
      const std::uint64_t size = rest.negative ? ~number : number;
      rest.size_class = static_cast<unsigned>(size >> fraction_bits_) + 1;
      rest.place = size & ((std::uint64_t{1} << fraction_bits_) - 1);
    } else {
      const std::uint64_t size = rest.negative ? 0 - number : number;
      rest.size_class = static_cast<unsigned>(std::bit_width(size));
      rest.place = size - (std::uint64_t{1} << (rest.size_class - 1));
    }
    return rest;
  }

  // The opposite of rest_of.
  std::uint64_t number_of(const Rest& rest) const {
    if (rest.size_class == 0) return 0;
    if (exponents_) {
      const std::uint64_t size =
          (std::uint64_t{rest.size_class - 1} << fraction_bits_) | rest.place;
      return rest.negative ? ~size : size;
    }
    const std::uint64_t size = (std::uint64_t{1} << (rest.size_class - 1)) + rest.place;
    return rest.negative ? 0 - size : size;
  }

 private:
  bool exponents_;
  int fraction_bits_;
};

// What holds for all rests of a polygon.
struct Limits {
  unsigned greatest_class = 0;
  bool negatives = false;
  bool off_scale = false;
};

// Whether vertex i is written without odds, as nothing is known of it yet.
inline bool stands_alone(Guess guess, std::size_t i) { return i == 0 && guess != Guess::nothing; }

// The limits of the vertices, written in this way; numbers the coordinates that are off the scale.
// O(n).
inline Limits limits_of(const Way& way, Cells& cells) {
  const Classes classes(way);
  Limits limits;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Cell& cell = cells[i][axis];
      const std::uint64_t guess = guess_number(way.guess, cells, i, axis);
      if (cell.off_scale) {
        cell.number = static_cast<std::int64_t>(guess);
        limits.off_scale = true;
      } else if (!stands_alone(way.guess, i)) {
        const Rest rest = classes.rest_of(static_cast<std::uint64_t>(cell.number) - guess);
        limits.greatest_class = std::max(limits.greatest_class, rest.size_class);
        limits.negatives = limits.negatives || rest.negative;
      }
    }
  }
  return limits;
}

// Writes or reads rests one after the other, learning their odds.
template <class Coder>
class RestCoder {
 public:
  RestCoder(Coder& coder, const Classes& classes, const Limits& limits)
      : coder_(coder), classes_(classes), limits_(limits) {}

  // Whether a coordinate is off the scale.
  bool code_off_scale(bool off_scale) {
    return limits_.off_scale && coder_.choice(off_scale, off_scale_odds_);
  }

  Rest code(Rest rest, std::size_t axis) {
    if (limits_.greatest_class == 0) return {};
    const bool zero = coder_.choice(rest.size_class == 0, zero_odds_[zeros_before_]);
    zeros_before_ = (zeros_before_ << 1 | (zero ? 1u : 0u)) & 3u;
    if (zero) {
      sign_before_[axis] = 0;
      return {};
    }
    rest.size_class = code_class(rest.size_class);
    rest.place = code_place(rest.place, rest.size_class);
    if (limits_.negatives) {
      rest.negative = coder_.choice(rest.negative, sign_odds_[sign_before_[axis]]);
    }
    sign_before_[axis] = rest.negative ? 2 : 1;
    return rest;
  }

 private:
  static constexpr unsigned steps = 16;

  // From the greatest class down, one question each; beyond 16 steps at once.
  unsigned code_class(unsigned size_class) {
    for (unsigned step = 0; step < steps; ++step) {
      const unsigned asked = limits_.greatest_class - step;
      if (asked == 1 || coder_.choice(size_class == asked, class_odds_[step])) return asked;
    }
    const unsigned left = limits_.greatest_class - steps;
    return coder_.uniform(Coder::decoding ? 0 : size_class - 1, left) + 1;
  }

  // The highest bit has odds, the others come as they are.
  std::uint64_t code_place(std::uint64_t place, unsigned size_class) {
    const int bits = classes_.place_bits(size_class);
    if (bits == 0) return 0;
    const unsigned below = limits_.greatest_class - size_class;
    const bool high = coder_.choice((place >> (bits - 1) & 1) != 0,
                                    high_odds_[below < steps ? below : steps - 1]);
    const std::uint64_t low = code_bits(coder_, place, bits - 1);
    return (std::uint64_t{high ? 1u : 0u} << (bits - 1)) | low;
  }

  static std::array<Odds, steps> all_alike(std::uint16_t count) {
    std::array<Odds, steps> odds;
    odds.fill(Odds{{count, count}});
    return odds;
  }

  Coder& coder_;
  const Classes& classes_;
  const Limits& limits_;
  Odds off_scale_odds_{{6, 1}};
  std::array<Odds, 4> zero_odds_{Odds{{6, 1}}, Odds{{6, 1}}, Odds{{6, 1}}, Odds{{6, 1}}};
  std::array<Odds, steps> class_odds_ = all_alike(2);
  std::array<Odds, steps> high_odds_ = all_alike(8);
  std::array<Odds, 3> sign_odds_{Odds{{4, 4}}, Odds{{4, 4}}, Odds{{4, 4}}};
  unsigned zeros_before_ = 0;              // of the last two rests
  std::array<unsigned, 2> sign_before_{};  // per axis: 0 none, 1 positive, 2 negative
};

template <class Coder>
Way code_way(Coder& coder, const Way& way) {
  int kind = way.scale.kind();
  const bool integers = coder.uniform(kind == 0 ? 1 : 0, 2) != 0;
  kind = integers ? 0
                  : 1 + static_cast<int>(coder.uniform(
                            static_cast<std::uint32_t>(kind > 0 ? kind - 1 : 0), Scale::doubles));
  int zero_bits = 0;
  if (kind == Scale::doubles) {
    zero_bits =
        static_cast<int>(coder.uniform(static_cast<std::uint32_t>(way.scale.zero_bits()), 53));
  }
  const auto guess = static_cast<Guess>(coder.uniform(static_cast<std::uint32_t>(way.guess), 4));
  return {Scale(kind, zero_bits), guess};
}

template <class Coder>
Limits code_limits(Coder& coder, Limits limits, const Way& way, const Classes& classes) {
  if (way.scale.decimal()) {
    Odds odds{{7, 1}};
    limits.off_scale = coder.choice(limits.off_scale, odds);
  }
  limits.greatest_class = coder.uniform(limits.greatest_class, classes.last() + 1);
  if (limits.greatest_class > 0) {
    limits.negatives = coder.uniform(limits.negatives ? 1 : 0, 2) != 0;
  }
  return limits;
}

// A number of a vertex that stands alone. O(1).
template <class Coder>
std::int64_t code_alone(Coder& coder, std::int64_t number) {
  auto size = static_cast<std::uint64_t>(number);
  if (number < 0) size = 0 - size;
  size = code_integer(coder, size, 64);
  if (size == 0) return 0;
  const bool negative = coder.uniform(number < 0 ? 1 : 0, 2) != 0;
  return static_cast<std::int64_t>(negative ? 0 - size : size);
}

// The vertices in the given way, which is read when decoding; `count` is known to both. The encoder
// reads `cells`, which have numbers of the scale; the decoder fills them, and stops early if it
// fails. O(count).
template <class Coder>
Way code_vertices(Coder& coder, Way way, Cells& cells, std::size_t count) {
  way = code_way(coder, way);
  const Classes classes(way);
  Limits limits;
  if constexpr (!Coder::decoding) limits = limits_of(way, cells);
  limits = code_limits(coder, limits, way, classes);

  RestCoder<Coder> rests(coder, classes, limits);
  for (std::size_t i = 0; i < count && !coder.failed(); ++i) {
    if constexpr (Coder::decoding) cells.emplace_back();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      Cell& cell = cells[i][axis];
      const std::uint64_t guess = guess_number(way.guess, cells, i, axis);
      cell.off_scale = rests.code_off_scale(cell.off_scale);
      if (cell.off_scale) {
        cell.value = from_bits(code_bits(coder, to_bits(cell.value), 64));
        cell.number = static_cast<std::int64_t>(guess);
        continue;
      }
      if (stands_alone(way.guess, i)) {
        cell.number = code_alone(coder, cell.number);
      } else {
        Rest rest;
        if constexpr (!Coder::decoding) {
          rest = classes.rest_of(static_cast<std::uint64_t>(cell.number) - guess);
        }
        rest = rests.code(rest, axis);
        cell.number = static_cast<std::int64_t>(guess + classes.number_of(rest));
      }
      if constexpr (Coder::decoding) cell.value = way.scale.value_of(cell.number);
    }
  }
  return way;
}

}  // namespace evenlift
