// Which robots get into each other's way.
#include <algorithm>

#include "evenlift/plane.h"
#include "evenlift/stands.h"

namespace evenlift {
namespace {

bool cross_each_other(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const auto sides_differ = [](const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    return (cross(q - p, r - p) > 0) != (cross(q - p, s - p) > 0);
  };
  return sides_differ(a, b, c, d) && sides_differ(c, d, a, b);
}

double distance_of_segments(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (cross_each_other(a, b, c, d)) return 0;
  return std::min({distance_to_segment(c, d, a), distance_to_segment(c, d, b),
                   distance_to_segment(a, b, c), distance_to_segment(a, b, d)});
}

}  // namespace

bool Stands::collide(const LiftingPoint& a, const LiftingPoint& b) const {
  const double apart = 2 * robot_.radius + robot_.gap - near_;
  if (apart > 0 && length(stand(a) - stand(b)) < apart) return true;
  if (robot_.width <= near_) return false;
  return distance_of_segments(contact(a), a.position, contact(b), b.position) <
         robot_.width - near_;
}

bool Stands::any_collide(const std::vector<LiftingPoint>& points) const {
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (collide(points[i], points[j])) return true;
  return false;
}

}  // namespace evenlift
