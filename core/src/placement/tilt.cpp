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

// The slope k1 for which k1 + k2 sqrt(1 + k1^2) is `most`; 0 if k2 alone is more.
double slope_beside(double k2, double most) {
  if (!(most > k2)) return 0;
  const double ratio = k2 / most;  // below 1; nothing overflows
  return most * ((1 - ratio) * (1 + ratio)) /
         (1 + ratio * std::sqrt(1 + (most - k2) * (most + k2)));
}

}  // namespace

Disturbance disturbance_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  return {shown.com_radius,      carrying.com_height, carrying.slope,
          carrying.acceleration, carrying.uneven,     carrying.give};
}

std::optional<Tilt> tilt_of(const Disturbance& disturbance, const DisturbanceEffect& effect,
                            double tipping_distance, double diameter) {
  const double height = disturbance.com_height, k2 = disturbance.acceleration;
  if (!(height > 0)) return std::nullopt;
  const double most = slope_within(tipping_distance - disturbance.com_radius, height);
  Tilt tilt;
  tilt.height = height;
  tilt.reach = effect.reach;
  tilt.stays = is_within_base(effect.reach, tipping_distance, diameter);
  tilt.slope = tilt.acceleration = most;
  tilt.degrees = slope_degrees(most);
  const double k1 = disturbance.slope + effect.tilt;
  if (disturbance.slope > 0)
    tilt.acceleration_left = std::max(0.0, (most - k1) / std::sqrt(1 + k1 * k1));
  if (k2 > 0) tilt.slope_left = std::max(0.0, slope_beside(k2, most) - effect.tilt);
  return tilt;
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
