#include <algorithm>
#include <cmath>

#include "evenlift/candidates.h"

namespace evenlift {

double place_towards(const PairRange& range, const Vec2& direction) {
  const double first = cross(range.a0, direction), last = cross(range.a1, direction);
  // C sees the edge under less than 180 degrees, so the two differ in sign where it sees the place.
  const double x = first == last ? range.first : first / (first - last);
  const bool ahead = dot(Vec2((1 - x) * range.a0 + x * range.a1), direction) > 0;
  if (ahead) return std::clamp(x, range.first, range.last);
  return std::fabs(first) < std::fabs(last) ? range.first : range.last;
}

}  // namespace evenlift
