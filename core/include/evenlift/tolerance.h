// The one tolerance of algorithm.md and every comparison that uses it. All else is exact.
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

inline constexpr double tau = 1e-9;

// Widest distance that counts as "within tau L", for a polygon whose bounding box has diagonal L.
inline double near_distance(double diagonal) { return tau * diagonal; }

// Whether two ratios or shares agree: absolutely, within tau.
bool ratios_tie(double a, double b);

// Whether two lengths agree: within tau times the larger.
bool lengths_tie(double a, double b);

// How far below the best score another still ties with it: tau of the best, or an absolute floor
// (1e-12 L^2, of distances 1e-12 L) where sums have cancelled.
double score_slack(double best, double floor);
inline constexpr double score_floor = 1e-12;

// Whether two directions agree: same side, sine of the angle between them at most tau.
bool directions_agree(const Vec2& a, const Vec2& b);

// Whether a direction counts as vertical.
bool is_vertical(const Vec2& direction);

}  // namespace evenlift
