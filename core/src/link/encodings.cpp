#include "link/encodings.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "exact/bits.h"

namespace evenlift {
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
