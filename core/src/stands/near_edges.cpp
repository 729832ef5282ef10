#include "stands/near_edges.h"

#include <cmath>

namespace evenlift {

// Rectangles are apart if their projections onto some side's normal are. Rounding is harmless:
// `around` includes a margin.
bool NearEdges::meets(const Surrounding& around, const Box& box) {
  const Vec2 half = box.size() / 2, middle = box.middle() - around.start;
  const auto apart = [&](const Vec2& axis, double low, double high) {
    const double at = dot(middle, axis);
    const double reach = half.x * std::fabs(axis.x) + half.y * std::fabs(axis.y);
    return at + reach < low || at - reach > high;
  };
  if (apart(around.along, around.x_low, around.x_high)) return false;
  if (apart(around.outward, around.y_low, around.y_high)) return false;
  const Vec2 own_middle = around.along * ((around.x_low + around.x_high) / 2) +
                          around.outward * ((around.y_low + around.y_high) / 2);
  const double width = (around.x_high - around.x_low) / 2,
               height = (around.y_high - around.y_low) / 2;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double reach = width * std::fabs(around.along[axis]) +
                         height * std::fabs(around.outward[axis]) + half[axis];
    if (std::fabs(own_middle[axis] - middle[axis]) > reach) return false;
  }
  return true;
}

}  // namespace evenlift
