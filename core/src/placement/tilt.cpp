#include "evenlift/tilt.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/angles.h"
#include "evenlift/predicates.h"

namespace evenlift {
namespace {

// Far beyond any slope, and still finite in %.
constexpr double most_shown = 1e300;

// The slope at which C is above an edge `room` away.
double slope_within(double room, double height) {
  return room > 0 ? std::min(room / height, most_shown) : 0;
}

}  // namespace

Disturbance disturbance_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  Disturbance disturbance;
  disturbance.reach =
      shown.com_radius + carrying.com_height * (carrying.slope + carrying.acceleration);
  if (carrying.give) disturbance.uneven = std::min(carrying.uneven / *carrying.give, most_shown);
  disturbance.kept = 1 / std::sqrt(1 + carrying.slope * carrying.slope);
  return disturbance;
}

std::optional<Tilt> tilt_of(const Shown& shown, double tipping_distance, double diameter) {
  const double height = shown.carrying.com_height;
  if (!(height > 0)) return std::nullopt;
  const double reach = disturbance_of(shown).reach;
  const double slope = slope_within(tipping_distance - shown.com_radius, height);
  return Tilt{
      height, reach, is_within_base(reach, tipping_distance, diameter), slope, slope_degrees(slope),
      slope};
}

double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown) {
  if (hull.size() < 3) return 0;
  const Vec2 downhill = direction / length(direction);
  double least = most_shown;
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

}  // namespace evenlift
