#include "evenlift/angles.h"

#include <cmath>

namespace evenlift {
namespace {

// pi / 2 in three parts. The first two have 33 significant bits, so small multiples of them are
// exact (Cody and Waite, Software Manual for the Elementary Functions, 1980).
constexpr double half_pi_1 = 1.57079632673412561417e+00;
constexpr double half_pi_2 = 6.07710050630396597660e-11;
constexpr double half_pi_3 = 2.02226624879595063154e-21;

// Taylor series for |x| <= pi / 4. The first omitted term is below 2^-60.
double sine_series(double x) {
  const double z = x * x;
  double sum = 0;
  for (int k = 19; k >= 3; k -= 2) sum = (1.0 + sum) * (-z / (k * (k - 1)));
  return x + x * sum;
}

double cosine_series(double x) {
  const double z = x * x;
  double sum = 0;
  for (int k = 20; k >= 2; k -= 2) sum = (1.0 + sum) * (-z / (k * (k - 1)));
  return 1.0 + sum;
}

struct Reduced {
  double remainder;  // in about [-pi / 4, pi / 4]
  int quadrant;      // 0 .. 3
};

Reduced reduce(double angle) {
  const double turns = std::floor(angle / half_pi_1 + 0.5);
  const double remainder = ((angle - turns * half_pi_1) - turns * half_pi_2) - turns * half_pi_3;
  const double quadrant = turns - 4 * std::floor(turns / 4);
  return {remainder, static_cast<int>(quadrant)};
}

// For t in [0, 1]. The angle is halved three times, by tan(a / 2) = t / (1 + sqrt(1 + t^2)). Then
// t <= tan(pi / 32) < 0.0985, where few terms of the series suffice.
double arctangent_unit(double t) {
  for (int i = 0; i < 3; ++i) t = t / (1.0 + std::sqrt(1.0 + t * t));
  const double z = t * t;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) sum = -z * (1.0 / k + sum);
  return 8.0 * (t + t * sum);
}

}  // namespace

double sine(double angle_rad) {
  const Reduced r = reduce(angle_rad);
  const double value = r.quadrant % 2 == 0 ? sine_series(r.remainder) : cosine_series(r.remainder);
  return r.quadrant < 2 ? value : -value;
}

double cosine(double angle_rad) {
  const Reduced r = reduce(angle_rad);
  const double value = r.quadrant % 2 == 0 ? cosine_series(r.remainder) : sine_series(r.remainder);
  return r.quadrant == 0 || r.quadrant == 3 ? value : -value;
}

double arctangent2(double y, double x) {
  const double ax = std::fabs(x), ay = std::fabs(y);
  if (ax == 0 && ay == 0) return 0;
  double angle = ax >= ay ? arctangent_unit(ay / ax) : pi / 2 - arctangent_unit(ax / ay);
  if (x < 0) angle = pi - angle;
  return y < 0 ? -angle : angle;
}

double slope_degrees(double ratio) { return arctangent2(ratio, 1) * (180 / pi); }

double slope_ratio(double degrees) {
  if (degrees == 45) return 1;
  const double angle = degrees * (pi / 180);
  return sine(angle) / cosine(angle);
}

}  // namespace evenlift
