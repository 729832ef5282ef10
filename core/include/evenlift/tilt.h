// Slopes, starts, stops and uneven ground. The results follow from the places of the robots, C and
// the numbers of Carrying (document.h). They do not affect where robots stand.
//
// On ground that slopes by the ratio k1, with an acceleration of k2 g, the resultant of weight and
// inertia meets the plane of the lifting points up to about h (k1 + k2) from C (exactly, if either
// is 0), where h is the height of C above that plane (the zero moment point; M. Vukobratovic and B.
// Borovac, Zero-moment point, 2004). The object tips when that point leaves the lifting base H.
// This presumes that the object is rigid, that robots push back, and that slopes and accelerations
// change slowly: it ignores swinging and bumps.
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
  bool stays = false;       // the reach is at most the tipping distance, within tolerance (tau L)
  double slope = 0;         // the slope at which it tips, as a ratio, if nothing accelerates it
  double degrees = 0;       // the same slope, as an angle
  double acceleration = 0;  // the acceleration in g at which it tips, on level ground
};

// Nothing if the height of C is 0. `tipping_distance` is that of uncertainty.h, and `diameter` L of
// the object. The slope and the acceleration allow for the C uncertainty, and are 0 if that alone
// can tip the object. O(1).
std::optional<Tilt> tilt_of(const Shown& shown, double tipping_distance, double diameter);

// The slope, as a ratio, at which the object tips if `direction`, of any length > 0, is downhill; 0
// if H has no area, or if the C uncertainty alone can tip it that way. `hull` must come from
// convex_hull, with C inside; the height must be above 0. O(h) for h corners.
double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown);

}  // namespace evenlift
