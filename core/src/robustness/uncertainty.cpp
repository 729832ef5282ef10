#include "evenlift/uncertainty.h"

#include <algorithm>
#include <limits>

#include "evenlift/predicates.h"
#include "robustness/known_size.h"

namespace evenlift {
namespace {

constexpr double most = std::numeric_limits<double>::max();

double change(double per_length, double radius) { return std::min(radius * per_length, most); }

}  // namespace

double tipping_distance(const Points& hull, const Vec2& centre, double diameter) {
  if (hull.size() < 3) return 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    least = std::min(least, orient(a, b, centre) / length(b - a));
  }
  return least > near_distance(known_size(hull, centre, diameter)) ? least : 0;
}

std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const SpringLoads& springs,
                                   double radius) {
  std::vector<LoadRange> ranges;
  ranges.reserve(loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double by = change(springs.per_length[i], radius);
    ranges.push_back({std::max(loads[i] - by, 0.0), std::min(loads[i] + by, most)});
  }
  return ranges;
}

double greatest_change(const SpringLoads& springs, double radius) {
  double greatest = 0;
  for (const double per_length : springs.per_length)
    greatest = std::max(greatest, change(per_length, radius));
  return greatest;
}

std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities) {
  double radius = std::min(springs.same_within, tipping_distance);
  for (std::size_t i = 0; i < springs.loads.size(); ++i) {
    if (!capacities[i]) continue;
    const double room = *capacities[i] - springs.loads[i];
    if (room < 0) return std::nullopt;
    if (springs.per_length[i] > 0) radius = std::min(radius, room / springs.per_length[i]);
  }
  return radius;
}

}  // namespace evenlift
