#include "evenlift/tolerance.h"

#include <algorithm>
#include <cmath>

namespace evenlift {

bool ratios_tie(double a, double b) { return std::fabs(a - b) <= tau; }

bool lengths_tie(double a, double b) { return std::fabs(a - b) <= tau * std::max(a, b); }

double score_slack(double best, double floor) { return std::max(tau * best, floor); }

bool directions_agree(const Vec2& a, const Vec2& b) {
  return dot(a, b) > 0 && std::fabs(cross(a, b)) <= tau * length(a) * length(b);
}

bool is_vertical(const Vec2& direction) {
  return std::fabs(direction.x()) <= tau * length(direction);
}

}  // namespace evenlift
