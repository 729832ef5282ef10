#include "evenlift/tolerance.h"

#include <algorithm>
#include <cmath>

namespace evenlift {

bool ratios_tie(double a, double b) { return std::fabs(a - b) <= tau; }

bool lengths_tie(double a, double b) { return std::fabs(a - b) <= tau * std::max(a, b); }

double score_slack(double best, double floor) { return std::max(tau * best, floor); }

bool exceeds(double load, double capacity) { return load > capacity * (1 + tau); }

bool directions_agree(const Vec2& a, const Vec2& b) {
  const double side = std::fabs(cross(a, b));
  // A cheap test that avoids two square roots in most calls.
  if (side > 2 * tau * (one_norm(a) * one_norm(b))) return false;
  return dot(a, b) > 0 && side <= tau * length(a) * length(b);
}

bool is_vertical(const Vec2& direction) {
  const double x = std::fabs(direction.x);
  return x <= 2 * tau * one_norm(direction) && x <= tau * length(direction);
}

}  // namespace evenlift
