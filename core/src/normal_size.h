// Exponents are shifted for polygons so small that products of coordinates would leave the range of
// doubles. Multiplying by a power of two is exact, and the results are those of the shifted
// polygon.
#pragma once

#include <cmath>

#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

inline void scale(Vec2& v, int exponent) {
  v = {std::ldexp(v.x(), exponent), std::ldexp(v.y(), exponent)};
}

inline void scale(Points& points, int exponent) {
  for (Vec2& p : points) scale(p, exponent);
}

// The exponent by which the document is too small, 0 for all but the smallest.
inline int exponent_of_small(const Points& vertices) {
  constexpr int smallest_exponent = -100;
  if (vertices.empty()) return 0;
  Vec2 low = vertices.front(), high = low;
  for (const Vec2& v : vertices) {
    low = low.cwiseMin(v);
    high = high.cwiseMax(v);
  }
  const double size = (high - low).maxCoeff();
  if (!std::isfinite(size) || size <= 0) return 0;
  int exponent = 0;
  std::frexp(size, &exponent);
  return exponent < smallest_exponent ? exponent : 0;
}

// The document with its polygon and centre of mass shifted up by that exponent.
inline Document of_normal_size(Document document, int exponent) {
  if (exponent == 0) return document;
  scale(document.vertices, -exponent);
  if (document.centre_of_mass) scale(*document.centre_of_mass, -exponent);
  return document;
}

}  // namespace evenlift
