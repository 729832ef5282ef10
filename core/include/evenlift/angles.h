// Sine, cosine and arctangent, computed with basic arithmetic and square roots. So the results have
// the same bits on every platform, unlike the C library's. Errors of these three are at most 4
// units in the last place of 1 (2^-50), or twice that for arctangents above 2 or below -2. Of the
// methods that place robots, only *equal angles* uses these functions.
#pragma once

namespace evenlift {

inline constexpr double pi = 3.14159265358979323846;

// The sine and the cosine of an angle in radians, for |angle_rad| up to 1e5. O(1).
double sine(double angle_rad);
double cosine(double angle_rad);

// The angle of the vector (x, y) from the x axis, in radians, in [-pi, pi]. Only rounding can make
// it -pi. It is 0 for the zero vector. O(1).
double arctangent2(double y, double x);

// slope_degrees() returns the angle of a slope, in [0, 90] degrees, from its ratio >= 0 (rise
// divided by run). slope_ratio() returns the ratio from an angle in [0, 90) degrees; it is exactly
// 1 for 45. O(1).
double slope_degrees(double ratio);
double slope_ratio(double degrees);

}  // namespace evenlift
