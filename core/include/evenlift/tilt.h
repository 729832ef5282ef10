// The effects of slopes, starts, stops and uneven ground, computed from the places of the robots, C
// and the numbers of Carrying (document.h). These numbers do not affect where robots stand.
//
// Let k1 be the slope of the plane of the lifting points, as a ratio, k2 the acceleration along the
// ground, in g, and h the height of C above that plane. Of the weight W, W / sqrt(1 + k1^2) acts
// across the plane. The resultant of weight and inertia meets the plane at the zero moment point (M.
// Vukobratovic and B. Borovac, Zero-moment point, 2004), at most h (k1 + k2 sqrt(1 + k1^2)) from C.
// The object tips when this point leaves the lifting base H, provided that the object is rigid, the
// robots push back, none is overloaded, and slope and acceleration change slowly. The computation
// ignores swinging and bumps.
#pragma once

#include <optional>

#include "evenlift/document.h"
#include "evenlift/uncertainty.h"
#include "evenlift/vec.h"

namespace evenlift {

// The disturbance that follows from the settings `com_radius`, height of C, `slope`,
// `acceleration`, `give` and `uneven`. O(1).
Disturbance disturbance_of(const Shown& shown);

// The conditions under which the object tips, in the worst direction and with C off by up to E.
struct Tilt {
  double height = 0;        // h > 0
  double reach = 0;         // DisturbanceEffect::reach
  bool stays = false;       // reach <= tipping distance, within tolerance (tau L)
  double slope = 0;         // the slope at which it tips, as a ratio, at rest on even ground
  double degrees = 0;       // `slope` as an angle
  double acceleration = 0;  // the acceleration at which it tips, in g, on level, even ground
  // The acceleration at which it tips on the given slope and uneven ground; empty without a slope.
  std::optional<double> acceleration_left;
  // The slope at which it tips with the given acceleration on uneven ground; empty without one.
  std::optional<double> slope_left;
};

// Computes when the object tips; returns nothing if the height of C is 0. `effect` is that of the
// disturbance on the robots, `tipping_distance` that of uncertainty.h, and `diameter` is L. Slopes
// and accelerations are 0 if the object tips without them. O(1).
std::optional<Tilt> tilt_of(const Disturbance& disturbance, const DisturbanceEffect& effect,
                            double tipping_distance, double diameter);

// The slope, as a ratio, at which the object tips without acceleration if the ground falls in
// `direction`, a vector of any length > 0. It is 0 if H has no area, or if the C uncertainty alone
// can tip the object that way. `hull` must come from convex_hull and contain C, and the height of C
// must be above 0. O(h) for h corners.
double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown);

}  // namespace evenlift
