#include "robustness/standard_frame.h"

#include <algorithm>
#include <cmath>

#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

// Within tolerance of this line through the centroid.
bool on_one_line(const Vec2& direction, const Points& offsets) {
  return std::all_of(offsets.begin(), offsets.end(), [&](const Vec2& d) {
    return std::fabs(cross(direction, d)) <= tau * length(direction);
  });
}

Vec2 with_mean_square_1(const Vec2& axis, const Points& offsets) {
  double square = 0;
  for (const Vec2& d : offsets) square += dot(axis, d) * dot(axis, d);
  return axis / std::sqrt(square / static_cast<double>(offsets.size()));
}

}  // namespace

StandardFrame standard_frame(const Points& points) {
  StandardFrame frame;
  for (const Vec2& p : points) frame.mean += p;
  frame.mean /= static_cast<double>(points.size());
  Points offsets;
  Vec2 farthest;
  for (const Vec2& p : points) {
    offsets.push_back(p - frame.mean);
    if (length(offsets.back()) > length(farthest)) farthest = offsets.back();
  }
  if (length(farthest) <= tau) return frame;
  frame.axis[0] = with_mean_square_1(farthest, offsets);
  if (on_one_line(farthest, offsets)) return frame;
  const Vec2 across = with_mean_square_1(left_normal(farthest), offsets);
  double together = 0;  // the coordinates' mean product, removed from the second axis
  for (const Vec2& d : offsets) together += dot(frame.axis[0], d) * dot(across, d);
  together /= static_cast<double>(points.size());
  frame.axis[1] = with_mean_square_1(across - together * frame.axis[0], offsets);
  return frame;
}

}  // namespace evenlift
