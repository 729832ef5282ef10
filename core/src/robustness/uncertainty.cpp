#include "evenlift/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "robustness/known_size.h"
#include "robustness/standard_frame.h"

namespace evenlift {
namespace {

constexpr double most = std::numeric_limits<double>::max();

// For each robot i, the sum of |P_ij| over j (uncertainty.h); 0 without load.
std::vector<double> sums_of_projection(const Points& robots, const Vec2& centre, double unit,
                                       const std::vector<double>& loads) {
  std::vector<std::size_t> bearing;
  Points places;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (!(loads[i] > 0)) continue;
    bearing.push_back(i);
    places.push_back((robots[i] - centre) / unit);
  }
  std::vector<double> sums(robots.size(), 0);
  if (bearing.empty()) return sums;
  const StandardFrame frame = standard_frame(places);
  const int axes = (frame.axis[0] != Vec2{}) + (frame.axis[1] != Vec2{});
  const std::size_t k = bearing.size();
  if (k <= static_cast<std::size_t>(axes) + 1) return sums;  // a plane fits any heights of these
  for (Vec2& place : places) place = frame(place);
  for (std::size_t i = 0; i < k; ++i)
    for (std::size_t j = 0; j < k; ++j)
      sums[bearing[i]] += std::fabs((i == j ? 1.0 : 0.0) -
                                    (1 + dot(places[i], places[j])) / static_cast<double>(k));
  return sums;
}

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

bool is_within_base(double reach, double tipping_distance, double diameter) {
  return reach <= tipping_distance + near_distance(diameter);
}

LoadChanges load_changes(const Points& robots, const Vec2& centre, double diameter, double weight,
                         const SpringLoads& springs, const Disturbance& disturbance) {
  LoadChanges changes{disturbance.kept, false, {}, {}};
  const bool some_idle = std::count(springs.loads.begin(), springs.loads.end(), 0.0) > 0;
  const bool out_of_reach = disturbance.reach <= springs.same_within && !(disturbance.uneven > 0);
  changes.others_may_carry = some_idle && !out_of_reach;
  for (const double per_length : springs.per_length)
    changes.by.push_back(std::min(disturbance.reach * per_length, most));
  if (disturbance.uneven > 0) {
    const double mean = weight / static_cast<double>(robots.size());
    const std::vector<double> sums =
        sums_of_projection(robots, centre, known_size(robots, centre, diameter), springs.loads);
    for (std::size_t i = 0; i < robots.size(); ++i)
      changes.by[i] = std::min(changes.by[i] + mean * (disturbance.uneven * sums[i]), most);
  }
  // If only rounding puts C outside H, the only known bound is the whole weight.
  changes.at_worst = worst_loads(robots, centre, diameter, weight, disturbance.reach)
                         .value_or(std::vector<double>(robots.size(), weight));
  return changes;
}

bool may_let_go(const std::vector<double>& loads, const LoadChanges& changes) {
  if (changes.others_may_carry) return true;
  double sum = 0;
  for (const double load : loads) sum += load;
  for (std::size_t i = 0; i < changes.by.size(); ++i)
    if (loads[i] - changes.by[i] < -tau * sum) return true;
  return false;
}

std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const LoadChanges& changes) {
  const bool lets_go = may_let_go(loads, changes);
  std::vector<LoadRange> ranges;
  ranges.reserve(loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i)
    ranges.push_back({std::max(changes.kept * loads[i] - changes.by[i], 0.0),
                      lets_go ? changes.at_worst[i] : std::min(loads[i] + changes.by[i], most)});
  return ranges;
}

std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities,
                                             const LoadChanges& besides, double reach) {
  const auto overloads = [&](std::size_t i, double load) {
    return capacities[i] && exceeds(load, *capacities[i]);
  };
  if (may_let_go(springs.loads, besides)) {
    for (std::size_t i = 0; i < springs.loads.size(); ++i)
      if (overloads(i, besides.at_worst[i])) return std::nullopt;
    return 0;
  }
  double radius = std::max(0.0, std::min(springs.same_within, tipping_distance) - reach);
  for (std::size_t i = 0; i < springs.loads.size(); ++i) {
    const double more = besides.by.empty() ? 0 : besides.by[i];
    // If heights are off, a robot goes slack sooner.
    if (more > 0 && springs.per_length[i] > 0)
      radius = std::min(radius, std::max(0.0, springs.loads[i] - more) / springs.per_length[i]);
    if (overloads(i, springs.loads[i] + more)) return std::nullopt;
    if (!capacities[i] || !(springs.per_length[i] > 0)) continue;
    const double room = std::max(0.0, *capacities[i] - springs.loads[i] - more);
    radius = std::min(radius, room / springs.per_length[i]);
  }
  return radius;
}

}  // namespace evenlift
