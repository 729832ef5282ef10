// Turns coordinates into integers without loss. The integers number the steps of a decimal grid, or
// the doubles in ascending order.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// A scale gives doubles their numbers.
class Scale {
 public:
  static constexpr int most_decimals = 22;           // higher powers of 10 are not doubles
  static constexpr int doubles = most_decimals + 1;  // the kind that numbers the doubles

  // `kind` is the number of decimals, 0 .. most_decimals, or `doubles`. With `doubles`, a double
  // has a number only if its lowest `zero_bits` (0 .. 52) bits are 0. The number omits these bits.
  explicit Scale(int kind, int zero_bits = 0) : kind_(kind), zero_bits_(zero_bits) {}
  int kind() const { return kind_; }
  bool decimal() const { return kind_ != doubles; }
  int zero_bits() const { return zero_bits_; }

  // The number of a finite value; nullopt if it has none. With k decimals, the number is the only
  // integer m, |m| < 2^51, for which m / 10^k, rounded once, equals the value bit for bit; -0 has
  // no number. With `doubles`, the number is the bit pattern of the absolute value, complemented if
  // the value is negative. So numbers ascend with values, 0 has number 0, and -0 has -1. O(1).
  std::optional<std::int64_t> number_of(double value) const;

  // The inverse of number_of. Any number has a value, which may be infinite or NaN. O(1).
  double value_of(std::int64_t number) const;

 private:
  int kind_;
  int zero_bits_;
};

// The least k for which Scale(k) has a number for this finite value; Scale::doubles if there is no
// such k. O(1).
int decimals_of(double value);

// --- Coordinates in share links as integers, called numbers (quantizer.h), and their predictors.

// Predicts a coordinate's number from the numbers of earlier vertices on the same axis.
enum class Predictor : std::uint8_t {
  nothing,   // always 0
  previous,  // the last vertex's number
  line,      // extrapolates the last two linearly
  repeat     // adds the step of four vertices ago to the last number; good for combs
};
inline constexpr Predictor all_predictors[] = {Predictor::nothing, Predictor::previous,
                                               Predictor::line, Predictor::repeat};

// The way in which vertices are coded. The writer tries several and keeps the shortest.
struct Encoding {
  Scale scale{0};
  Predictor predictor = Predictor::nothing;
};

// A value that has no number on the scale is `escaped`: the link contains the double itself, and
// later predictions use the number that was predicted for it.
struct QuantizedCoordinate {
  double value = 0;
  std::int64_t number = 0;
  bool escaped = false;
};
using QuantizedVertices = std::vector<std::array<QuantizedCoordinate, 2>>;

// The predicted number for vertex i. It wraps around beyond 64 bits. O(1).
inline std::uint64_t predict(Predictor predictor, const QuantizedVertices& quantized, std::size_t i,
                             std::size_t axis) {
  const auto back = [&](std::size_t steps) {
    return static_cast<std::uint64_t>(quantized[i - steps][axis].number);
  };
  if (i == 0 || predictor == Predictor::nothing) return 0;
  if (predictor == Predictor::line && i >= 2) return 2 * back(1) - back(2);
  if (predictor == Predictor::repeat && i >= 5) return back(1) + back(4) - back(5);
  return back(1);
}

// The vertices' coordinates with their numbers on the scale. O(n).
QuantizedVertices quantize(const Scale& scale, const Points& vertices);

// --- Encodings of a polygon that are worth trying. The choice is not part of the format: readers
// accept every encoding.

struct QuantizedPolygon {
  Encoding encoding;
  QuantizedVertices quantized;
};

// Returns at least one encoding, and several for a small polygon. The choice depends only on
// integers, so every platform makes the same one. O(n).
std::vector<QuantizedPolygon> likely_encodings(const Points& vertices);

}  // namespace evenlift
