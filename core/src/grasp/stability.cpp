#include "evenlift/stability.h"

#include <algorithm>
#include <cmath>

#include "evenlift/tolerance.h"
#include "polygon/clip.h"

namespace evenlift {
namespace {

// The force that tips at q, on the line of a segment H beyond its end r.
double force_beyond_end(const Vec2& r, const Vec2& centre, double weight, const Vec2& q) {
  return weight * length(r - centre) / length(q - r);
}

double segment_tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q) {
  const Vec2 &a = hull[0], &b = hull[1];
  const Vec2 line = b - a;
  if (std::fabs(cross(line, q - a)) > tau * dot(line, line)) return 0;
  const double along = dot(q - a, line) / dot(line, line);
  if (along < 0) return force_beyond_end(a, centre, weight, q);
  if (along > 1) return force_beyond_end(b, centre, weight, q);
  return std::numeric_limits<double>::infinity();
}

}  // namespace

double coverage(const Polygon& polygon, const Points& hull) {
  if (hull.size() < 3) return 0;
  // Coordinates are relative to a corner of H, so that a polygon far from the origin loses no
  // digits.
  const Vec2& origin = hull.front();
  Points part;
  part.reserve(polygon.size());
  for (const Vec2& v : polygon.vertices()) part.push_back(v - origin);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    // The direction is taken from the corners as they are. If two of them differ only by rounding,
    // translation would change it.
    part = clip_left_of_ray(part, hull[i] - origin, hull[(i + 1) % hull.size()] - hull[i]);
  }
  return std::clamp(std::fabs(signed_area(part)) / polygon.area(), 0.0, 1.0);
}

double tipping_force(const Points& hull, const Vec2& centre, double weight, const Vec2& q) {
  if (hull.size() < 2) return 0;
  if (hull.size() == 2) return segment_tipping_force(hull, centre, weight, q);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double beyond = cross(b - a, q - a);
    if (beyond >= 0) continue;
    least = std::min(least, weight * (cross(b - a, centre - a) / -beyond));
  }
  return least;
}

}  // namespace evenlift
