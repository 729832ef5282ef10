// The one tolerance of algorithm.md, the comparisons within this tolerance, and ties between sets
// of robots. All other decisions are exact. All functions are O(1).
#pragma once

#include "evenlift/vec.h"

namespace evenlift {

inline constexpr double tau = 1e-9;

// The distance tau L, for a polygon of diameter L.
inline double near_distance(double diameter) { return tau * diameter; }

// Whether two ratios or shares differ by at most tau.
bool ratios_tie(double a, double b);

// Whether two lengths >= 0 differ by at most tau times the larger.
bool lengths_tie(double a, double b);

// The greatest amount by which a score may be below the best and still tie: tau times the best, but
// at least `floor`, since differences of sums lose digits. The floor is score_floor times L^2 or,
// for the metric `distance`, score_floor times L. If the shortest edge of H has a length
// e < short_edge * L, the floor for `distance` is multiplied by short_edge * L / e.
double score_slack(double best, double floor);
inline constexpr double score_floor = 1e-12;
inline constexpr double short_edge = 1e-3;

// The coverages of two sets of robots tie if they differ by at most coverage_tie. The sums of the
// robots' squared distances from C tie if they differ by at most spread_tie times the larger sum.
inline constexpr double coverage_tie = 1e-9;
inline constexpr double spread_tie = 1e-9;

// Whether a load exceeds the capacity by more than tau times the capacity. A smaller excess may be
// due to rounding alone.
bool exceeds(double load, double capacity);

// Whether the angle between two directions is below 90 degrees and its sine is at most tau.
bool directions_agree(const Vec2& a, const Vec2& b);

// Whether the sine of the angle between the direction and the y axis is at most tau.
bool is_vertical(const Vec2& direction);

}  // namespace evenlift
