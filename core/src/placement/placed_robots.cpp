#include "evenlift/placed_robots.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "evenlift/angles.h"
#include "evenlift/closure.h"
#include "evenlift/predicates.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "placement/robot_drift.h"
#include "polygon/corners.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

// On along the outline, or back.
ErrorDirection along_outline(const Polygon& polygon, const LiftingPoint& point) {
  const double near = near_distance(polygon.diameter());
  const auto along = [&](std::size_t edge) {
    const Vec2 way = polygon.edge_end(edge) - polygon.edge_start(edge);
    return way / length(way);
  };
  std::size_t on = point.edge, back = point.edge;
  if (length(point.position - polygon.edge_start(point.edge)) <= near)
    back = polygon.previous(point.edge);
  else if (length(point.position - polygon.edge_end(point.edge)) <= near)
    on = polygon.next(point.edge);
  return {ErrorDirection::Kind::along, {along(on), -along(back)}};
}

}  // namespace

RobotDrift::RobotDrift(const Polygon& polygon, const LiftingPoint& contact, bool in_notch)
    : polygon_(polygon), contact_(contact), in_notch_(in_notch) {}

double RobotDrift::way(double arm, double error) const {
  if (in_notch_) return 0;
  if (!(arm > 0) || contact_.edge == beneath) return error;
  return error + arm * greatest_turn(polygon_, contact_.position, contact_.edge, error);
}

std::vector<RobotDrift> drifts_of(const Placement& placement) {
  const std::vector<LiftingPoint> points = contact_points(placement);
  std::vector<bool> in_notch(points.size(), false);
  for (const Contact& contact : contacts(placement.polygon(), points))
    if (contact.in_notch) in_notch[contact.point] = true;
  std::vector<RobotDrift> drifts;
  drifts.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    drifts.emplace_back(placement.polygon(), points[i], in_notch[i]);
  return drifts;
}

std::vector<ErrorDirection> error_directions(const Placement& placement,
                                             const std::vector<RobotDrift>& drifts) {
  using Kind = ErrorDirection::Kind;
  const Polygon& polygon = placement.polygon();
  std::vector<ErrorDirection> directions;
  for (const LiftingPoint& point : lifting_points(placement.teams)) {
    ErrorDirection direction;
    if (point.edge == beneath)
      direction.kind = Kind::any;
    else if (!drifts[directions.size()].is_fixed())
      direction = along_outline(polygon, point);
    directions.push_back(direction);
  }
  return directions;
}

namespace {

// Far beyond any slope, and still finite in %.
constexpr double most_shown = 1e300;

// The slope at which C is above an edge `room` away.
double slope_within(double room, double height) {
  return room > 0 ? std::min(room / height, most_shown) : 0;
}

// The slope k1 for which k1 + k2 sqrt(1 + k1^2) is `most`; 0 if k2 alone is more.
double slope_beside(double k2, double most) {
  if (!(most > k2)) return 0;
  const double ratio = k2 / most;  // below 1; nothing overflows
  return most * ((1 - ratio) * (1 + ratio)) /
         (1 + ratio * std::sqrt(1 + (most - k2) * (most + k2)));
}

}  // namespace

Disturbance disturbance_of(const Shown& shown) {
  const Carrying& carrying = shown.carrying;
  return {shown.com_radius,      carrying.com_height, carrying.slope,
          carrying.acceleration, carrying.uneven,     carrying.give};
}

std::optional<Tilt> tilt_of(const Disturbance& disturbance, const DisturbanceEffect& effect,
                            double tipping_distance, double diameter) {
  const double height = disturbance.height, k2 = disturbance.acceleration;
  if (!(height > 0)) return std::nullopt;
  const double most = slope_within(tipping_distance - disturbance.com_radius, height);
  Tilt tilt;
  tilt.height = height;
  tilt.reach = effect.reach;
  tilt.stays = is_within_base(effect.reach, tipping_distance, diameter);
  tilt.slope = tilt.acceleration = most;
  tilt.degrees = slope_degrees(most);
  const double k1 = disturbance.slope + effect.tilt;
  if (disturbance.slope > 0)
    tilt.acceleration_left = std::max(0.0, (most - k1) / std::sqrt(1 + k1 * k1));
  if (k2 > 0) tilt.slope_left = std::max(0.0, slope_beside(k2, most) - effect.tilt);
  return tilt;
}

double tipping_slope(const Points& hull, const Vec2& centre, const Vec2& direction,
                     const Shown& shown) {
  if (hull.size() < 3) return 0;
  const Vec2 downhill = direction / length(direction);
  double least = most_shown;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const Vec2 &a = hull[i], &b = hull[(i + 1) % hull.size()];
    const double edge = length(b - a);
    const double towards = -cross(b - a, downhill) / edge;
    if (!(towards > 0)) continue;
    const double room = orient(a, b, centre) / edge - shown.com_radius;
    least = std::min(least, slope_within(room, shown.carrying.com_height * towards));
  }
  return least;
}

namespace {

Points positions_of_all(const Placement& placement) {
  return positions(lifting_points(placement.teams));
}

double diameter(const Placement& placement) { return placement.polygon().diameter(); }

// For the directions that robots face.
class Outline {
 public:
  Outline(const Points& vertices, double near)
      : vertices_(vertices), counter_clockwise_(is_counter_clockwise(vertices)), near_(near) {}

  // A vector towards the object, of any length. Only robots without a body can be at a vertex.
  Vec2 inward_at(const LiftingPoint& point, bool has_body) const {
    if (has_body) return normal(point.edge);
    const std::size_t n = vertices_.size(), edge = point.edge, next = (edge + 1) % n;
    if (length(point.position - vertices_[edge]) <= near_)
      return inward_between((edge + n - 1) % n, edge);
    if (length(point.position - vertices_[next]) <= near_) return inward_between(edge, next);
    return normal(edge);
  }

 private:
  Vec2 normal(std::size_t edge) const {
    return inward_normal(vertices_[edge], vertices_[(edge + 1) % vertices_.size()],
                         counter_clockwise_);
  }

  // The direction halfway between two normals. The first sum vanishes if they are opposite, the
  // second if they are equal; both point the same way.
  Vec2 inward_between(std::size_t edge, std::size_t next) const {
    const Vec2 a = normal(edge), b = normal(next);
    const Vec2 apart = left_normal(a) - left_normal(b);
    return (a + b) + (cross(a, b) < 0 ? Vec2(-apart) : apart);
  }

  const Points& vertices_;
  bool counter_clockwise_;
  double near_;
};

std::vector<double> loads_of(LoadModel model, const Placement& placement,
                             const std::optional<ModelLoads>& models) {
  switch (model) {
    case LoadModel::plan:
      break;
    case LoadModel::springs:
      return models->springs.loads;
    case LoadModel::best:
      return std::vector<double>(models->worst.size(), models->best);
    case LoadModel::worst:
      return models->worst;
  }
  return planned_loads(placement.teams);
}

LoadChanges changes_of(LoadModel model, const ModelLoads& models) {
  LoadChanges changes = models.changes;
  const std::vector<double>& doubt =
      model == LoadModel::plan ? models.planned_doubt : models.springs_doubt;
  for (std::size_t i = 0; i < doubt.size(); ++i) changes.by[i] += doubt[i];
  return changes;
}

std::vector<LoadRange> single(const std::vector<double>& loads) {
  std::vector<LoadRange> ranges;
  ranges.reserve(loads.size());
  for (const double load : loads) ranges.push_back({load, load});
  return ranges;
}

// In (-180, 180]: rounding may turn an angle just above -180 into -180.
double degrees_of(const Vec2& direction) {
  const double degrees = arctangent2(direction.y + 0.0, direction.x) * (180 / pi);
  return degrees > -180 ? degrees : 180;
}

}  // namespace

std::vector<PlacedRobot> placed_robots(const Placement& placement) {
  const Outline outline(placement.vertices(), near_distance(diameter(placement)));
  std::vector<PlacedRobot> robots;
  robots.reserve(count_robots(placement.teams));
  const Stands* stands = placement.stands.get();
  for (std::size_t t = 0; t < placement.teams.size(); ++t) {
    for (const Robot& robot : placement.teams[t].robots) {
      const LiftingPoint& point = robot.point;
      const bool is_beneath = point.edge == beneath;
      const Vec2 inward =
          is_beneath ? Vec2(1, 0) : outline.inward_at(point, stands && stands->has_body());
      const double heading_deg = degrees_of(inward);
      robots.push_back(
          {point.position, stands ? stands->contact(point) : point.position,
           stands ? stands->stand(point) : point.position, is_beneath,
           placement.number_of(robots.size()), std::string(placement.name_of(robots.size())),
           static_cast<std::uint32_t>(t), robot.load, heading_deg, inward / length(inward)});
    }
  }
  return robots;
}

std::optional<ModelLoads> model_loads(const Placement& placement, const Disturbance& disturbance) {
  const Points robots = positions_of_all(placement);
  const Vec2& centre = placement.centre_of_mass;
  const double size = diameter(placement), weight = placement.weight();
  const auto springs = spring_loads(robots, centre, size, weight);
  const auto best = best_load(robots, centre, size, weight);
  const auto worst = worst_loads(robots, centre, size, weight);
  if (!springs || !best || !worst) return std::nullopt;
  ModelLoads models{*springs, *best, *worst, disturbance};
  if (disturbance.any())
    models.changes = load_changes(robots, centre, size, weight, *springs, disturbance);
  return models;
}

ModelLoads with_inaccuracy(ModelLoads models, const Placement& placement) {
  const double accuracy = placement.settings.accuracy.value_or(0);
  if (!(accuracy > 0)) return models;
  const Points robots = positions_of_all(placement);
  const Vec2& centre = placement.centre_of_mass;
  const double size = diameter(placement), weight = placement.weight();
  const auto changes = [&](const Disturbance& disturbance) {
    return load_changes(robots, centre, size, weight, models.springs, disturbance);
  };
  if (!models.disturbance.any()) models.changes = changes({});
  // The lifting base moves by no more than its robots.
  Disturbance wider = models.disturbance;
  wider.com_radius += accuracy;
  LoadChanges at_worst = changes(wider);
  models.changes.others_may_carry = at_worst.others_may_carry;
  models.changes.at_worst = std::move(at_worst.at_worst);
  models.changes.at_least = std::move(at_worst.at_least);
  const auto directions = error_directions(placement, drifts_of(placement));
  const auto doubt = [&](const std::vector<double>& loads, bool are_planned) {
    const LoadErrors errors(robots, centre, known_size(robots, centre, size), weight, loads,
                            are_planned, directions);
    std::vector<double> sums;
    for (std::size_t i = 0; i < robots.size(); ++i) sums.push_back(accuracy * errors.sum(i));
    return sums;
  };
  models.springs_doubt = doubt(models.springs.loads, false);
  models.planned_doubt = placement.settings.method == Method::given
                             ? models.springs_doubt
                             : doubt(planned_loads(placement.teams), true);
  return models;
}

std::vector<LoadRange> loads_by(LoadModel model, const Placement& placement,
                                const std::optional<ModelLoads>& models) {
  if (!models) model = LoadModel::plan;
  const std::vector<double> loads = loads_of(model, placement, models);
  if (models && has_ranges(model) && models->are_ranges())
    return load_ranges(loads, changes_of(model, *models));
  return single(loads);
}

bool may_let_go(LoadModel model, const Placement& placement,
                const std::optional<ModelLoads>& models) {
  return models && has_ranges(model) && models->are_ranges() &&
         evenlift::may_let_go(loads_of(model, placement, models), changes_of(model, *models));
}

std::vector<LoadRange> shown_loads(const Placement& placement, LoadModel model,
                                   const std::optional<ModelLoads>& models, bool tips) {
  if (models && has_ranges(model) && tips) return single(loads_of(model, placement, models));
  return loads_by(model, placement, models);
}

Equilibrium equilibrium(const Placement& placement) {
  return analyse_equilibrium(positions_of_all(placement), placement.centre_of_mass,
                             diameter(placement));
}

bool loads_are_determined(const Placement& placement) {
  const std::size_t robots = count_robots(placement.teams);
  return robots <= 3 && placement.lifting_base.size() == robots;
}

std::vector<Misfit> misfits(const Placement& placement) {
  if (placement.settings.method != Method::given) return {};
  return misfits(placement.polygon(), placement.stands.get(), lifting_points(placement.teams));
}

Robustness robustness(const Placement& placement) {
  const Points robots = positions_of_all(placement);
  const Vec2& centre = placement.centre_of_mass;
  const double size = diameter(placement);
  return {failures_carried(robots, centre, size), failures_steady(robots, centre, size),
          tipping_distance(placement.lifting_base, centre, size),
          failures_steady(robots, centre, size, hold_requirements(placement).inside)};
}

DisturbanceEffect effect_on(const ShownPlacement& of) {
  return effect_on(positions_of_all(of.placement), of.placement.centre_of_mass,
                   diameter(of.placement), disturbance_of(of.shown));
}

double tipping_force(const ShownPlacement& of, const Vec2& q) {
  const Placement& placement = of.placement;
  return tipping_force(placement.lifting_base, placement.centre_of_mass, placement.weight(), q,
                       effect_on(of).reach);
}

std::optional<std::vector<double>> worst_loads(const Placement& placement,
                                               const DisturbanceEffect& effect) {
  return worst_loads(positions_of_all(placement), placement.centre_of_mass, diameter(placement),
                     placement.weight(), effect.reach_of_loads);
}

std::vector<TiltCircle> tilt_circles(const ShownPlacement& of, double scale) {
  constexpr double angles_deg[] = {1, 2, 5, 10, 15, 20, 30, 45, 60};
  const double asked = of.shown.carrying.slope;
  constexpr double least_gap = 16, least_labelled = 40;  // pixels
  const double height = of.shown.carrying.com_height;
  const Placement& placement = of.placement;
  std::vector<TiltCircle> circles;
  if (!(height > 0) || placement.lifting_base.size() < 3 || !placement.loads) return circles;
  double farthest = 0, drawn = 0;
  for (const Vec2& corner : placement.lifting_base)
    farthest = std::max(farthest, length(corner - placement.centre_of_mass));
  const auto radius_at = [&](double slope) { return of.shown.com_radius + height * slope; };
  // The slope that is set is shown whatever its neighbours.
  const double kept = asked > 0 ? radius_at(asked) : -least_gap / scale;
  for (const double degrees : angles_deg) {
    const double radius = radius_at(slope_ratio(degrees));
    if (radius > farthest || radius * scale < drawn + least_gap ||
        std::abs(radius - kept) * scale < least_gap)
      continue;
    drawn = radius * scale;
    circles.push_back({degrees, radius, drawn >= least_labelled});
  }
  if (asked > 0 && kept <= farthest) {
    const auto after = std::find_if(circles.begin(), circles.end(),
                                    [&](const TiltCircle& circle) { return circle.radius > kept; });
    circles.insert(after, {slope_degrees(asked), kept, kept * scale >= least_labelled, true});
  }
  return circles;
}

std::vector<std::optional<RestOfRobots>> single_failures(const Placement& placement,
                                                         const Disturbance& disturbance) {
  return single_failures(placement.object, placement.centre_of_mass, placement.weight(),
                         placement.teams, hold_requirements(placement).inside, disturbance);
}

std::optional<RestOfRobots> single_failure(const Placement& placement, std::size_t robot,
                                           const Disturbance& disturbance) {
  return single_failure(placement.object, placement.centre_of_mass, placement.weight(),
                        placement.teams, robot, hold_requirements(placement).inside, disturbance);
}

std::optional<std::vector<LoadRange>> ranges_without(const Placement& placement, std::size_t robot,
                                                     const Disturbance& disturbance) {
  Points others = positions_of_all(placement);
  const auto place = static_cast<std::ptrdiff_t>(robot);
  others.erase(others.begin() + place);
  const Vec2& centre = placement.centre_of_mass;
  const double size = diameter(placement), weight = placement.weight();
  const auto springs = spring_loads(others, centre, size, weight);
  if (!springs) return std::nullopt;
  const Disturbance of_others = after_failure(disturbance, others.size() + 1);
  std::vector<LoadRange> ranges =
      disturbance.any() ? load_ranges(springs->loads, load_changes(others, centre, size, weight,
                                                                   *springs, of_others))
                        : single(springs->loads);
  ranges.insert(ranges.begin() + place, LoadRange{});
  return ranges;
}

}  // namespace evenlift
