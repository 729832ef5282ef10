// Sine, cosine and arctangent from + - x / and square roots only, so their bits are the same on
// every platform, unlike the C library's. Errors are below 4 units in the last place of 1. In a
// placement, only the method of equal angles uses them.
#pragma once

namespace evenlift {

inline constexpr double pi = 3.14159265358979323846;

// Valid for |angle_rad| up to 1e5. O(1).
double sine(double angle_rad);
double cosine(double angle_rad);

// The angle of (x, y) in (-pi, pi], or -pi by rounding; 0 for the zero vector. O(1).
double arctangent2(double y, double x);

// Degrees in [0, 90] from a slope's ratio >= 0, and the ratio from degrees in [0, 90), exactly 1
// for 45. O(1).
double slope_degrees(double ratio);
double slope_ratio(double degrees);

}  // namespace evenlift
