// Sine, cosine and arctangent, computed with + - x / and square roots only. So they give the same
// bits on every platform, unlike the functions of the C library. Errors are below 4 units in the
// last place of 1. In a placement, only the method of equal angles needs angles; the rest is
// algebra. Generators, imports, slopes, labels and the headings of robots also use angles.
#pragma once

namespace evenlift {

inline constexpr double pi = 3.14159265358979323846;

// Valid for |angle_rad| up to 1e5. O(1).
double sine(double angle_rad);
double cosine(double angle_rad);

// The angle of (x, y) in (-pi, pi]; 0 for the zero vector. An angle so little above -pi that it
// rounds to -pi is returned as -pi. O(1).
double arctangent2(double y, double x);

// An angle in degrees, in [0, 90], from the ratio of a slope >= 0; and the ratio of an angle in
// [0, 90), which is exactly 1 for 45. O(1).
double slope_degrees(double ratio);
double slope_ratio(double degrees);

}  // namespace evenlift
