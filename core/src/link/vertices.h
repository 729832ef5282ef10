// Codes the vertices, supports and holes of share links (records.h). Each coordinate is quantized
// to an integer, which is predicted from earlier vertices. The residual is the integer less its
// prediction, and is mostly small. Adaptive models code whether it is zero, its size and its sign.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "exact/pseudo_angle.h"
#include "link/quantizer.h"
#include "link/range_coder.h"

namespace evenlift {

// A residual as its sign, its size class, and its place within that class. Class 0 holds only the
// residual 0.
struct Residual {
  bool negative = false;
  unsigned size_class = 0;
  std::uint64_t place = 0;
};

// Groups residuals of similar size into classes, as the exponent of a double does with doubles.
class ResidualClasses {
 public:
  explicit ResidualClasses(const Encoding& encoding)
      : exponents_(!encoding.scale.decimal() && encoding.predictor == Predictor::nothing),
        fraction_bits_(52 - encoding.scale.zero_bits()) {}

  unsigned last() const { return exponents_ ? 2047 : 64; }

  // The number of bits of a place in this class. The class must be above 0.
  int place_bits(unsigned size_class) const {
    return exponents_ ? fraction_bits_ : static_cast<int>(size_class) - 1;
  }

  // The residual for this difference modulo 2^64. Class c holds the sizes of c bits or, for doubles
  // without a predictor, those whose exponent field is c - 1.
  Residual residual_of(std::uint64_t number) const {
    Residual residual;
    residual.negative = (number >> 63) != 0;
    if (number == 0) return residual;
    if (exponents_) {
      const std::uint64_t size = residual.negative ? ~number : number;
      residual.size_class = static_cast<unsigned>(size >> fraction_bits_) + 1;
      residual.place = size & ((std::uint64_t{1} << fraction_bits_) - 1);
    } else {
      const std::uint64_t size = residual.negative ? 0 - number : number;
      residual.size_class = static_cast<unsigned>(std::bit_width(size));
      residual.place = size - (std::uint64_t{1} << (residual.size_class - 1));
    }
    return residual;
  }

  std::uint64_t number_of(const Residual& residual) const {
    if (residual.size_class == 0) return 0;
    if (exponents_) {
      const std::uint64_t size =
          (std::uint64_t{residual.size_class - 1} << fraction_bits_) | residual.place;
      return residual.negative ? ~size : size;
    }
    const std::uint64_t size = (std::uint64_t{1} << (residual.size_class - 1)) + residual.place;
    return residual.negative ? 0 - size : size;
  }

 private:
  bool exponents_;
  int fraction_bits_;
};

// Bounds on all residuals of a polygon. In a link the bounds precede the vertices, so impossible
// cases take no bits.
struct Limits {
  unsigned greatest_class = 0;
  bool negatives = false;
  bool escaped = false;
};

// Whether a predictor is used but has no vertex before vertex i.
inline bool has_no_prediction(Predictor predictor, std::size_t i) {
  return i == 0 && predictor != Predictor::nothing;
}

// Finds the limits of the residuals, and gives escaped coordinates their predicted numbers. O(n).
inline Limits limits_of(const Encoding& encoding, QuantizedVertices& quantized) {
  const ResidualClasses classes(encoding);
  Limits limits;
  for (std::size_t i = 0; i < quantized.size(); ++i) {
    for (std::size_t axis = 0; axis < 2; ++axis) {
      QuantizedCoordinate& coordinate = quantized[i][axis];
      const std::uint64_t prediction = predict(encoding.predictor, quantized, i, axis);
      if (coordinate.escaped) {
        coordinate.number = static_cast<std::int64_t>(prediction);
        limits.escaped = true;
      } else if (!has_no_prediction(encoding.predictor, i)) {
        const Residual residual =
            classes.residual_of(static_cast<std::uint64_t>(coordinate.number) - prediction);
        limits.greatest_class = std::max(limits.greatest_class, residual.size_class);
        limits.negatives = limits.negatives || residual.negative;
      }
    }
  }
  return limits;
}

// Codes residuals with models that adapt to earlier residuals.
template <class Coder>
class ResidualCoder {
 public:
  ResidualCoder(Coder& coder, const ResidualClasses& classes, const Limits& limits)
      : coder_(coder), classes_(classes), limits_(limits) {}

  bool code_escape(bool escaped) {
    return limits_.escaped && coder_.code_bit(escaped, escape_model_);
  }

  Residual code(Residual residual, std::size_t axis) {
    if (limits_.greatest_class == 0) return {};
    const bool zero = coder_.code_bit(residual.size_class == 0, zero_models_[zeros_before_]);
    zeros_before_ = (zeros_before_ << 1 | (zero ? 1u : 0u)) & 3u;
    if (zero) {
      sign_before_[axis] = 0;
      return {};
    }
    residual.size_class = code_class(residual.size_class);
    residual.place = code_place(residual.place, residual.size_class);
    if (limits_.negatives) {
      residual.negative = coder_.code_bit(residual.negative, sign_models_[sign_before_[axis]]);
    }
    sign_before_[axis] = residual.negative ? 2 : 1;
    return residual;
  }

 private:
  static constexpr unsigned steps = 16;

  // For each class, from the greatest down, codes whether it is the residual's. After 16 such
  // decisions it codes the class itself.
  unsigned code_class(unsigned size_class) {
    for (unsigned step = 0; step < steps; ++step) {
      const unsigned asked = limits_.greatest_class - step;
      if (asked == 1 || coder_.code_bit(size_class == asked, class_models_[step])) return asked;
    }
    const unsigned left = limits_.greatest_class - steps;
    return coder_.code_uniform(Coder::decoding ? 0 : size_class - 1, left) + 1;
  }

  // Codes the place. Only its highest bit has an adaptive model.
  std::uint64_t code_place(std::uint64_t place, unsigned size_class) {
    const int bits = classes_.place_bits(size_class);
    if (bits == 0) return 0;
    const unsigned below = limits_.greatest_class - size_class;
    const bool high = coder_.code_bit((place >> (bits - 1) & 1) != 0,
                                      high_bit_models_[below < steps ? below : steps - 1]);
    const std::uint64_t low = code_bits(coder_, place, bits - 1);
    return (std::uint64_t{high ? 1u : 0u} << (bits - 1)) | low;
  }

  static std::array<BitModel, steps> all_alike(std::uint16_t count) {
    std::array<BitModel, steps> model;
    model.fill(BitModel{{count, count}});
    return model;
  }

  Coder& coder_;
  const ResidualClasses& classes_;
  const Limits& limits_;
  BitModel escape_model_{{6, 1}};
  std::array<BitModel, 4> zero_models_{BitModel{{6, 1}}, BitModel{{6, 1}}, BitModel{{6, 1}},
                                       BitModel{{6, 1}}};
  std::array<BitModel, steps> class_models_ = all_alike(2);
  std::array<BitModel, steps> high_bit_models_ = all_alike(8);
  std::array<BitModel, 3> sign_models_{BitModel{{4, 4}}, BitModel{{4, 4}}, BitModel{{4, 4}}};
  unsigned zeros_before_ = 0;              // the last two residuals, one bit each: 1 if it was 0
  std::array<unsigned, 2> sign_before_{};  // per axis: 0 zero, 1 positive, 2 negative
};

template <class Coder>
Encoding code_encoding(Coder& coder, const Encoding& encoding) {
  int kind = encoding.scale.kind();
  const bool integers = coder.code_uniform(kind == 0 ? 1 : 0, 2) != 0;
  kind = integers ? 0
                  : 1 + static_cast<int>(coder.code_uniform(
                            static_cast<std::uint32_t>(kind > 0 ? kind - 1 : 0), Scale::doubles));
  int zero_bits = 0;
  if (kind == Scale::doubles) {
    zero_bits = static_cast<int>(
        coder.code_uniform(static_cast<std::uint32_t>(encoding.scale.zero_bits()), 53));
  }
  const auto predictor =
      static_cast<Predictor>(coder.code_uniform(static_cast<std::uint32_t>(encoding.predictor), 4));
  return {Scale(kind, zero_bits), predictor};
}

template <class Coder>
Limits code_limits(Coder& coder, Limits limits, const Encoding& encoding,
                   const ResidualClasses& classes) {
  if (encoding.scale.decimal()) {
    BitModel model{{7, 1}};
    limits.escaped = coder.code_bit(limits.escaped, model);
  }
  limits.greatest_class = coder.code_uniform(limits.greatest_class, classes.last() + 1);
  if (limits.greatest_class > 0) {
    limits.negatives = coder.code_uniform(limits.negatives ? 1 : 0, 2) != 0;
  }
  return limits;
}

// Codes the number of a coordinate without prediction. O(1).
template <class Coder>
std::int64_t code_unpredicted(Coder& coder, std::int64_t number) {
  auto size = static_cast<std::uint64_t>(number);
  if (number < 0) size = 0 - size;
  size = code_integer(coder, size, 64);
  if (size == 0) return 0;
  const bool negative = coder.code_uniform(number < 0 ? 1 : 0, 2) != 0;
  return static_cast<std::int64_t>(negative ? 0 - size : size);
}

// Codes the vertices' encoding and `count` vertices. Returns the encoding. For an encoder,
// `quantized` must hold numbers on the encoding's scale. A decoder fills `quantized`, and stops
// early if it fails. O(count).
template <class Coder>
Encoding code_vertices(Coder& coder, Encoding encoding, QuantizedVertices& quantized,
                       std::size_t count) {
  encoding = code_encoding(coder, encoding);
  const ResidualClasses classes(encoding);
  Limits limits;
  if constexpr (!Coder::decoding) limits = limits_of(encoding, quantized);
  limits = code_limits(coder, limits, encoding, classes);

  ResidualCoder<Coder> residuals(coder, classes, limits);
  for (std::size_t i = 0; i < count && !coder.failed(); ++i) {
    if constexpr (Coder::decoding) quantized.emplace_back();
    for (std::size_t axis = 0; axis < 2; ++axis) {
      QuantizedCoordinate& coordinate = quantized[i][axis];
      const std::uint64_t prediction = predict(encoding.predictor, quantized, i, axis);
      coordinate.escaped = residuals.code_escape(coordinate.escaped);
      if (coordinate.escaped) {
        coordinate.value = from_bits(code_bits(coder, to_bits(coordinate.value), 64));
        coordinate.number = static_cast<std::int64_t>(prediction);
        continue;
      }
      if (has_no_prediction(encoding.predictor, i)) {
        coordinate.number = code_unpredicted(coder, coordinate.number);
      } else {
        Residual residual;
        if constexpr (!Coder::decoding) {
          residual =
              classes.residual_of(static_cast<std::uint64_t>(coordinate.number) - prediction);
        }
        residual = residuals.code(residual, axis);
        coordinate.number = static_cast<std::int64_t>(prediction + classes.number_of(residual));
      }
      if constexpr (Coder::decoding) coordinate.value = encoding.scale.value_of(coordinate.number);
    }
  }
  return encoding;
}

}  // namespace evenlift
