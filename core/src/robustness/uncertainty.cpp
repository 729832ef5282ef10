#include "evenlift/uncertainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/tolerance.h"
#include "exact/pseudo_angle.h"
#include "exact/sorted_indices.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

constexpr double most = std::numeric_limits<double>::max();
constexpr double unbounded = std::numeric_limits<double>::infinity();

// The greatest sum of |v . a| over the arms a, for any unit vector v. It is the distance of the
// farthest corner of the arms' zonotope, the set of all sums of s a with -1 <= s <= 1. The corners
// follow each other as the arms, all turned upwards, change sign in the order of their directions.
// O(m log m).
double widest_sum(Points arms) {
  Vec2 corner;
  for (Vec2& arm : arms) {
    if (arm.y < 0 || (arm.y == 0 && arm.x < 0)) arm = -arm;
    corner += arm;
  }
  double greatest = length(corner);
  for (const std::uint32_t i : sorted_indices(arms.size(), [&](std::uint32_t a, std::uint32_t b) {
         return pseudo_angle(arms[a]) < pseudo_angle(arms[b]);
       })) {
    corner -= 2 * arms[i];
    greatest = std::max(greatest, length(corner));
  }
  return greatest;
}

// The slope by which heights that are off by 1 may tilt the object (effect_on). Along a line of
// robots, it is the slope of that line.
double tilt_per_height(const Points& robots, const Vec2& centre, double unit) {
  Points places;
  for (const Vec2& robot : robots) places.push_back((robot - centre) / unit);
  const StandardFrame frame = standard_frame(places);
  for (Vec2& place : places) {
    const Vec2 q = frame(place);
    place = (q.x * frame.axis[0] + q.y * frame.axis[1]) / static_cast<double>(robots.size());
  }
  return widest_sum(std::move(places)) / unit;
}

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

// All but the least loads.
LoadChanges greatest_changes(const Points& robots, const Vec2& centre, double diameter,
                             double weight, const SpringLoads& springs,
                             const Disturbance& disturbance) {
  LoadChanges changes{effect_on(robots, centre, diameter, disturbance), false, {}, {}, {}};
  const DisturbanceEffect& effect = changes.effect;
  const bool some_idle = std::count(springs.loads.begin(), springs.loads.end(), 0.0) > 0;
  const bool out_of_reach = effect.reach <= springs.same_within && !(effect.uneven > 0);
  changes.others_may_carry = some_idle && !out_of_reach;
  for (const double per_length : springs.per_length)
    changes.by.push_back(std::min(effect.reach_of_loads * per_length, most));
  if (effect.uneven > 0) {
    const double mean = weight / static_cast<double>(robots.size());
    const std::vector<double> sums =
        sums_of_projection(robots, centre, known_size(robots, centre, diameter), springs.loads);
    for (std::size_t i = 0; i < robots.size(); ++i)
      if (sums[i] > tau)
        changes.by[i] = std::min(changes.by[i] + mean * (effect.uneven * sums[i]), most);
  }
  // If only rounding puts C outside H, the only known bound is the whole weight.
  changes.at_worst = worst_loads(robots, centre, diameter, weight, effect.reach_of_loads)
                         .value_or(std::vector<double>(robots.size(), weight));
  return changes;
}

std::vector<double> upper_ends(const std::vector<double>& loads, const LoadChanges& changes) {
  if (may_let_go(loads, changes)) return changes.at_worst;
  std::vector<double> ends;
  for (std::size_t i = 0; i < loads.size(); ++i)
    ends.push_back(std::min(loads[i] + changes.by[i], most));
  return ends;
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

DisturbanceEffect effect_on(const Points& robots, const Vec2& centre, double diameter,
                            const Disturbance& disturbance) {
  const double height = disturbance.height, k2 = disturbance.acceleration;
  DisturbanceEffect effect;
  if (disturbance.uneven > 0 && height > 0 && !robots.empty())
    effect.tilt =
        disturbance.uneven * tilt_per_height(robots, centre, known_size(robots, centre, diameter));
  const double k1 = disturbance.slope + effect.tilt, across = std::sqrt(1 + k1 * k1);
  effect.reach = disturbance.com_radius + height * (k1 + k2 * across);
  effect.reach_of_loads = disturbance.com_radius + height * (k1 + k2);
  if (disturbance.uneven > 0)
    effect.uneven =
        disturbance.give ? std::min(disturbance.uneven / *disturbance.give, most) : unbounded;
  effect.kept = 1 / across;
  return effect;
}

Disturbance after_failure(Disturbance disturbance, std::size_t robots) {
  const auto m = static_cast<double>(robots);
  if (disturbance.give && robots > 1) *disturbance.give *= m / (m - 1);
  return disturbance;
}

bool is_within_base(double reach, double tipping_distance, double diameter) {
  return reach <= tipping_distance + near_distance(diameter);
}

LoadChanges load_changes(const Points& robots, const Vec2& centre, double diameter, double weight,
                         const SpringLoads& springs, const Disturbance& disturbance) {
  LoadChanges changes = greatest_changes(robots, centre, diameter, weight, springs, disturbance);
  changes.at_least = least_loads(robots, centre, diameter, weight, changes.effect.reach)
                         .value_or(std::vector<double>(robots.size(), 0));
  for (double& load : changes.at_least) load *= changes.effect.kept;
  return changes;
}

std::vector<double> greatest_loads(const Points& robots, const Vec2& centre, double diameter,
                                   double weight, const std::vector<double>& loads,
                                   const SpringLoads& springs, const Disturbance& disturbance) {
  return upper_ends(loads,
                    greatest_changes(robots, centre, diameter, weight, springs, disturbance));
}

bool may_let_go(const std::vector<double>& loads, const LoadChanges& changes) {
  if (changes.others_may_carry) return true;
  double sum = 0;
  for (const double load : loads) sum += load;
  for (std::size_t i = 0; i < changes.by.size(); ++i)
    if (changes.effect.kept * loads[i] - changes.by[i] < -tau * sum) return true;
  return false;
}

std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const LoadChanges& changes) {
  const bool lets_go = may_let_go(loads, changes);
  const std::vector<double> upper = upper_ends(loads, changes);
  std::vector<LoadRange> ranges;
  ranges.reserve(loads.size());
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const double least = std::max(changes.effect.kept * loads[i] - changes.by[i], 0.0);
    ranges.push_back({lets_go ? changes.at_least[i] : least, upper[i]});
  }
  return ranges;
}

std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities,
                                             const LoadChanges& besides) {
  const auto overloads = [&](std::size_t i, double load) {
    return capacities[i] && exceeds(load, *capacities[i]);
  };
  if (may_let_go(springs.loads, besides)) {
    for (std::size_t i = 0; i < springs.loads.size(); ++i)
      if (overloads(i, besides.at_worst[i])) return std::nullopt;
    return 0;
  }
  double radius =
      std::max(0.0, std::min(springs.same_within, tipping_distance) - besides.effect.reach);
  for (std::size_t i = 0; i < springs.loads.size(); ++i) {
    const double more = besides.by.empty() ? 0 : besides.by[i];
    // If heights are off, or on a slope, a robot goes slack sooner.
    if ((more > 0 || besides.effect.kept < 1) && springs.per_length[i] > 0)
      radius = std::min(radius, std::max(0.0, besides.effect.kept * springs.loads[i] - more) /
                                    springs.per_length[i]);
    if (overloads(i, springs.loads[i] + more)) return std::nullopt;
    if (!capacities[i] || !(springs.per_length[i] > 0)) continue;
    const double room = std::max(0.0, *capacities[i] - springs.loads[i] - more);
    radius = std::min(radius, room / springs.per_length[i]);
  }
  return radius;
}

namespace {

constexpr std::size_t most_exact = 1000;

Points in_units(const Points& robots, const Vec2& centre, double unit) {
  Points places;
  places.reserve(robots.size());
  for (const Vec2& robot : robots) places.push_back((robot - centre) / unit);
  return places;
}

StandardFrame frame_of(const Points& places, const std::vector<double>& loads) {
  Points carrying;
  for (std::size_t i = 0; i < places.size(); ++i)
    if (loads[i] > 0) carrying.push_back(places[i]);
  return carrying.empty() ? StandardFrame{} : standard_frame(carrying);
}

}  // namespace

LoadErrors::LoadErrors(const Points& robots, const Vec2& centre, double unit, double weight,
                       std::vector<double> loads, bool are_planned,
                       std::vector<ErrorDirection> directions)
    : robots_(robots),
      centre_(centre),
      unit_(unit),
      weight_(weight),
      loads_(std::move(loads)),
      are_planned_(are_planned),
      directions_(std::move(directions)),
      places_(in_units(robots, centre, unit)) {
  const StandardFrame frame = frame_of(places_, loads_);
  for (Vec2& place : places_) place = frame(place);
  axis_[0] = frame.axis[0];
  axis_[1] = frame.axis[1];
  of_centre_ = frame({});
  for (const double load : loads_) {
    carrying_ += load > 0 ? 1 : 0;
    total_ += load;
  }
}

Vec2 LoadErrors::derivative(std::size_t i, std::size_t j) const {
  const auto in_plane = [&](const Vec2& q) { return axis_[0] * q.x + axis_[1] * q.y; };
  Vec2 sum = in_plane(places_[i]) * -loads_[j];
  if (!are_planned_ && loads_[j] > 0) {
    const double p = (i == j ? 1.0 : 0.0) - (1 + dot(places_[i], places_[j])) / carrying_;
    sum += in_plane(of_centre_) * (p * weight_);
  }
  return sum / (carrying_ * unit_);
}

double LoadErrors::sum(std::size_t i) const {
  if (!(loads_[i] > 0)) return 0;
  if (loads_.size() > most_exact) {
    // The sum of |P_ij| is at most the root of m, since P is a projection.
    const auto size = [&](const Vec2& q) { return length(axis_[0] * q.x + axis_[1] * q.y); };
    return (size(places_[i]) * total_ +
            (are_planned_ ? 0 : size(of_centre_) * std::sqrt(carrying_) * weight_)) /
           (carrying_ * unit_);
  }
  double sum = 0;
  for (std::size_t j = 0; j < loads_.size(); ++j) sum += dot(derivative(i, j), worst_way(i, j));
  return sum;
}

Vec2 LoadErrors::worst_way(std::size_t i, std::size_t j) const {
  const ErrorDirection& direction = directions_[j];
  const Vec2 by = derivative(i, j);
  switch (direction.kind) {
    case ErrorDirection::Kind::none:
      break;
    case ErrorDirection::Kind::any:
      if (const double size = length(by); size > 0) return by / size;
      break;
    case ErrorDirection::Kind::along: {
      const double first = dot(by, direction.ways[0]), second = dot(by, direction.ways[1]);
      if (std::max(first, second) >= 0) return direction.ways[first < second ? 1 : 0];
    }
  }
  return {};
}

Points LoadErrors::worst_errors(std::size_t i) const {
  Points errors;
  errors.reserve(robots_.size());
  for (std::size_t j = 0; j < robots_.size(); ++j) errors.push_back(worst_way(i, j));
  return errors;
}

Vec2 LoadErrors::other_way(std::size_t j, const Vec2& way) const {
  const ErrorDirection& direction = directions_[j];
  if (direction.kind != ErrorDirection::Kind::along) return -way;
  return direction.ways[way == direction.ways[0] ? 1 : 0];
}

std::vector<double> LoadErrors::planned_at(const Points& robots) const {
  const Points places = in_units(robots, centre_, unit_);
  const StandardFrame frame = frame_of(places, loads_);
  Vec2 moment;  // of the planned loads about C
  for (std::size_t i = 0; i < places.size(); ++i) moment += places[i] * loads_[i];
  const Vec2 in_frame{dot(frame.axis[0], moment), dot(frame.axis[1], moment)};
  std::vector<double> loads;
  loads.reserve(places.size());
  for (std::size_t i = 0; i < places.size(); ++i)
    loads.push_back(loads_[i] > 0 ? loads_[i] - dot(frame(places[i]), in_frame) / carrying_ : 0);
  return loads;
}

}  // namespace evenlift
