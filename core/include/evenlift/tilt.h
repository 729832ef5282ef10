// The effects of slopes, starts, stops and uneven ground, from the places of the robots, C and the
// numbers of Carrying (document.h). They do not affect where robots stand.
//
// Let k1 be the slope of the ground, as a ratio, k2 the acceleration, in g, and h the height of C
// above the plane of the lifting points. The resultant of weight and inertia meets that plane at
// the zero moment point (M. Vukobratovic and B. Borovac, Zero-moment point, 2004), which is at most
// about h (k1 + k2) from C (exactly, if k1 or k2 is 0). The object tips when that point leaves the
// lifting base H. This presumes a rigid object, robots that push back, and slow changes of slope
// and acceleration: it ignores swinging and bumps.
#pragma once

#include <optional>

#include "evenlift/document.h"
#include "evenlift/uncertainty.h"
#include "evenlift/vec.h"

namespace evenlift {

// The disturbance that follows from the settings `com_radius`, `com_height`, `slope`,
// `acceleration`, `give` and `uneven`. O(1).
Disturbance disturbance_of(const Shown& shown);

// When the object tips, in the worst direction.
struct Tilt {
  double height = 0;        // h > 0
  double reach = 0;         // Disturbance::reach
  bool stays = false;       // reach <= tipping distance, within tolerance (tau L)
  double slope = 0;         // the slope at which it tips, as a ratio, without acceleration
  double degrees = 0;       // this slope as an angle
  double acceleration = 0;  // the acceleration at which it tips, in g, on level ground
};

// Computes when the object tips; empty if the height of C is 0. `tipping_distance` is that of
// uncertainty.h, and `diameter` is L. Slope and acceleration allow for the C uncertainty, and are 0
// if that alone can tip the object. O(1).
std::optional<Tilt> tilt_of(const Shown& shown, double tipping_distance, double diameter);

// The slope, as a ratio, at which the object tips if `direction`, of any length > 0, is downhill; 0
// if H has no area, or if the C uncertainty alone can tip it that way. `hull` must come from
// convex_hull, with C inside, at a height above 0. O(h) for h corners.
double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown);

}  // namespace evenlift
