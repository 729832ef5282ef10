#include "link/quantized.h"

namespace evenlift {

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

}  // namespace evenlift
