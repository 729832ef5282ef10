// Geometry in plain doubles, for drawing, for finding what is under the pointer, and where a
// tolerance allows for rounding. To decide on which side of a line a point lies, use predicates.h.
#pragma once

#include <algorithm>
#include <utility>

#include "evenlift/vec.h"

namespace evenlift {

// Whether p is inside the polygon, that is, whether a ray from p crosses the boundary an odd number
// of times. On the boundary the result may be either. O(n).
inline bool inside(const Points& polygon, const Vec2& p) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y))
      odd = !odd;
  }
  return odd;
}

// The point of the segment from a to b that is nearest to p. O(1).
inline Vec2 nearest_on_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 along = b - a;
  const double square = dot(along, along);
  if (!(square > 0)) return a;
  return a + along * std::clamp(dot(p - a, along) / square, 0.0, 1.0);
}

// The distance of p from the segment from a to b. The segment may be a point. O(1).
inline double distance_to_segment(const Vec2& a, const Vec2& b, const Vec2& p) {
  return length(p - nearest_on_segment(a, b, p));
}

// Clips a closed polygon to the half-plane where `depth`, a linear function of a point, is at
// least 0: one step of Sutherland and Hodgman's clipping (Reentrant polygon clipping, 1974). If the
// polygon is not convex, overlapping edges along the half-plane's line may connect parts of the
// result. `kept` receives the result, and keeps its memory between calls. O(n).
template <class Depth>
void clip(const Points& polygon, Depth depth, Points& kept) {
  kept.clear();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 &a = polygon[i], &b = polygon[i + 1 == polygon.size() ? 0 : i + 1];
    const double at_a = depth(a), at_b = depth(b);
    if (at_a >= 0) kept.push_back(a);
    if ((at_a < 0) != (at_b < 0)) kept.push_back(a + (b - a) * (at_a / (at_a - at_b)));
  }
}

// The part of the polygon inside the box. O(n).
inline Points clip(Points polygon, const Box& box) {
  Points kept;
  const auto keep = [&](auto depth) {
    clip(polygon, depth, kept);
    polygon.swap(kept);
  };
  keep([&](const Vec2& p) { return p.x - box.low.x; });
  keep([&](const Vec2& p) { return box.high.x - p.x; });
  keep([&](const Vec2& p) { return p.y - box.low.y; });
  keep([&](const Vec2& p) { return box.high.y - p.y; });
  return polygon;
}

}  // namespace evenlift
