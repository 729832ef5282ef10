#include "evenlift/tilt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/angles.h"
#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"

namespace evenlift {
namespace {

constexpr double most = std::numeric_limits<double>::max();

// The slope at which the point that is `room` away reaches the edge.
double slope_within(double room, double height) {
  return room > 0 ? std::min(room / height, most) : 0;
}

}  // namespace

Doubt doubt_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  Doubt doubt;
  doubt.reach =
      shown.com_radius + carrying.com_height * (carrying.slope + carrying.acceleration);
  if (carrying.give) doubt.uneven = std::min(carrying.uneven / *carrying.give, most);
  doubt.kept = 1 / std::sqrt(1 + carrying.slope * carrying.slope);
  return doubt;
}

std::optional<Tilt> tilt_of(const Shown& shown, double tipping_distance, double diameter) {
  const double height = shown.carrying.com_height;
  if (!(height > 0)) return std::nullopt;
  const double reach = doubt_of(shown).reach;
  const double slope = slope_within(tipping_distance - shown.com_radius, height);
  return Tilt{height,
              reach,
              reach <= tipping_distance + near_distance(diameter),
              slope,
              slope_degrees(slope),
              slope};
}

double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown) {
  if (hull.size() < 3) return 0;
  const Vec2 downhill = direction / length(direction);
  double least = most;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double edge = length(b - a);
    const double towards = -cross(b - a, downhill) / edge;
    if (!(towards > 0)) continue;
    const double room = orient(a, b, centre) / edge - shown.com_radius;
    least = std::min(least, slope_within(room, shown.carrying.com_height * towards));
  }
  return least;
}

double slope_degrees(double ratio) { return arctangent2(ratio, 1) * (180 / pi); }

double slope_ratio(double degrees) {
  if (degrees == 45) return 1;
  const double angle = degrees * (pi / 180);
  return sine(angle) / cosine(angle);
}

}  // namespace evenlift
