#include "evenlift/extra_load.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "evenlift/capacity.h"
#include "evenlift/hull.h"
#include "evenlift/stability.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "polygon/corners.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct LinearPart {
  double constant = 0;
  Vec2 slope;
  double operator()(const Vec2& q) const { return constant + dot(slope, q); }
};

// The part of a convex ring where the function is >= 0. O(corners).
Points part_above_0(const Points& ring, const LinearPart& function) {
  const double square = dot(function.slope, function.slope);
  if (!(square > 0)) return function.constant >= 0 ? ring : Points();
  const Vec2 from = function.slope * (-function.constant / square);
  return clip_left_of_ray(ring, from, -left_normal(function.slope));
}

// The part of a weight at q that a robot carries, and its room.
struct Bearing {
  LinearPart part;
  double least_room = 0;  // its load by springs minus its change by the disturbance, which counts
                          // for more where less of the weight acts on the robots
  double greatest_room = infinity;  // its capacity minus its load, minus that change
};

// With C at the origin and L, or more (known_size.h), as the unit of length.
class Lift {
 public:
  explicit Lift(const ShownPlacement& of)
      : of_(of),
        robots_(positions(lifting_points(of.placement.teams))),
        unit_(known_size(robots_, of.placement.centre_of_mass, diameter())) {}

  // Nothing if the robots are on one line, or if the change of some load has no bound.
  std::optional<std::vector<Bearing>> bearings() const;

  Points seen(const Points& points) const {
    Points all;
    for (const Vec2& point : points) all.push_back((point - of_.placement.centre_of_mass) / unit_);
    return all;
  }
  // The corners in the object's coordinates, without those that only rounding makes; none if their
  // area is 0.
  Points corners(const Points& ring) const {
    Points all;
    for (const Vec2& point : ring) all.push_back(of_.placement.centre_of_mass + unit_ * point);
    Points hull = convex_hull(all, near_distance(diameter()));
    return hull.size() < 3 ? Points() : hull;
  }
  Points box() const {
    const Box box = bounding_box(of_.placement.vertices());
    return seen({box.low, Vec2(box.high.x, box.low.y), box.high, Vec2(box.low.x, box.high.y)});
  }

 private:
  double diameter() const { return of_.placement.polygon().diameter(); }

  // Of all loads, as if no robot were slack.
  LoadChanges changes(const std::vector<Bearing>& bearings) const {
    const double weight = of_.placement.weight();
    SpringLoads springs{std::vector<double>(robots_.size(), weight), {}, infinity};
    for (const Bearing& bearing : bearings)
      springs.per_length.push_back(weight * (length(bearing.part.slope) / unit_));
    return load_changes(robots_, of_.placement.centre_of_mass, diameter(), weight, springs,
                        disturbance_of(of_.shown));
  }

  const ShownPlacement& of_;
  Points robots_;
  double unit_;
};

std::optional<std::vector<Bearing>> Lift::bearings() const {
  const Points places = seen(robots_);
  const StandardFrame frame = standard_frame(places);
  if (frame.axis[1] == Vec2{}) return std::nullopt;
  const double weight = of_.placement.weight(), m = static_cast<double>(robots_.size());
  std::vector<Bearing> all;
  for (const Vec2& place : places) {
    const Vec2 at = frame(place);
    const Vec2 slope = at.x * frame.axis[0] + at.y * frame.axis[1];
    all.push_back({{(1 - dot(slope, frame.mean)) / m, slope / m}});
  }
  const LoadChanges changed = changes(all);
  const std::vector<std::optional<double>> limits = limits_of(of_);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double load = weight * all[i].part.constant, by = changed.by[i];
    if (by == std::numeric_limits<double>::max()) return std::nullopt;
    all[i].least_room = (1 - of_.shown.carrying.weight_doubt) * (load - by / changed.effect.kept);
    if (limits[i]) all[i].greatest_room = *limits[i] - load - by;
  }
  return all;
}

// The greatest weight for which every robot has room, at any of these points.
std::optional<double> weight_anywhere(const std::vector<Bearing>& bearings, const Points& points) {
  double most = infinity;
  for (const Bearing& bearing : bearings) {
    if (bearing.least_room < 0 || bearing.greatest_room < 0) return 0;
    double least = infinity, greatest = -infinity;
    for (const Vec2& point : points) {
      const double part = bearing.part(point);
      least = std::min(least, part);
      greatest = std::max(greatest, part);
    }
    if (least < -tau) most = std::min(most, bearing.least_room / -least);
    if (greatest > tau) most = std::min(most, bearing.greatest_room / greatest);
  }
  if (most == infinity) return std::nullopt;
  return most;
}

}  // namespace

std::optional<std::vector<double>> loads_with(const Placement& placement, double weight,
                                              const Vec2& at) {
  const double all = placement.weight() + weight;
  const Vec2 centre = placement.centre_of_mass + (weight / all) * (at - placement.centre_of_mass);
  auto springs = spring_loads(positions(lifting_points(placement.teams)), centre,
                              placement.polygon().diameter(), all);
  if (!springs) return std::nullopt;
  return std::move(springs->loads);
}

std::optional<ExtraLoad> extra_load(const ShownPlacement& of) {
  const std::optional<double>& weight = of.shown.carrying.extra;
  if (!weight || !of.placement.loads) return std::nullopt;
  const Lift lift(of);
  const auto bearings = lift.bearings();
  if (!bearings) return ExtraLoad{*weight, {}, 0, 0.0};
  Points ring = lift.box();
  for (const Bearing& bearing : *bearings) {
    const LinearPart more{*weight * bearing.part.constant, *weight * bearing.part.slope};
    ring = part_above_0(ring, {more.constant + bearing.least_room, more.slope});
    if (std::isfinite(bearing.greatest_room))
      ring = part_above_0(ring, {bearing.greatest_room - more.constant, -more.slope});
  }
  ExtraLoad extra{*weight, lift.corners(ring), 0, {}};
  if (!extra.region.empty()) extra.share = coverage(of.placement.object, extra.region);
  extra.anywhere = weight_anywhere(*bearings, lift.seen(convex_hull(of.placement.vertices(), 0)));
  return extra;
}

}  // namespace evenlift
