// Coordinates in share links as integers, called numbers (quantizer.h), and their predictors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/vec.h"
#include "link/quantizer.h"

namespace evenlift {

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

}  // namespace evenlift
