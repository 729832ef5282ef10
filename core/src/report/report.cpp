#include "evenlift/report.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "evenlift/predicates.h"
#include "evenlift/stands.h"
#include "evenlift/tolerance.h"
#include "exact/sorted_indices.h"
#include "placement/robot_drift.h"
#include "robustness/support.h"

namespace evenlift {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using First = Accuracy::First;

// The supremum of the x in [0, high] at which a condition that holds at 0, and ends once, holds.
template <class Condition>
double last_that(double high, const Condition& holds) {
  if (holds(high)) return high;
  double low = 0;
  constexpr int halvings = 50;
  for (int i = 0; i < halvings; ++i) {
    const double middle = low + (high - low) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

// Where robots have room: their usable parts, and each other.
class Room {
 public:
  Room(const Placement& placement, const std::vector<RobotDrift>& drifts)
      : polygon_(placement.polygon()),
        stands_(*placement.stands),
        robots_(lifting_points(placement.teams)),
        drifts_(drifts) {}

  std::optional<First> first() const {
    First first{Promise::fits, infinite, {}, {}};
    for (std::size_t i = 0; i < robots_.size(); ++i)
      if (const double within = along(i); within < first.within)
        first = {Promise::fits, within, {i}, robots_[i].edge};
    if (stands_.has_body()) look_at_pairs(first);
    if (first.within == infinite) return std::nullopt;
    return first;
  }

 private:
  // A body does not come round a corner.
  double along(std::size_t robot) const {
    const LiftingPoint& point = robots_[robot];
    if (point.edge == beneath || drifts_[robot].is_fixed()) return infinite;
    const auto way = [&](bool on) {
      return stands_.way_to_end(polygon_, point.edge, stands_.along(point), on, !stands_.has_body())
          .length;
    };
    return std::min(way(true), way(false));
  }

  // Of robots whose contacts are farther apart along the x axis than this, none is first.
  double farthest_worth(const First& first) const {
    const RobotSize& size = stands_.robot();
    return 2 * (first.within + size.depth + size.radius + size.reach + size.radius + size.width) +
           size.gap;
  }

  void look_at_pairs(First& first) const {
    std::vector<double> x;
    for (const LiftingPoint& robot : robots_) x.push_back(stands_.contact(robot).x);
    const auto order =
        sorted_indices(x.size(), [&](std::uint32_t a, std::uint32_t b) { return x[a] < x[b]; });
    for (std::size_t k = 0; k < order.size(); ++k)
      for (std::size_t l = k + 1; l < order.size(); ++l) {
        if (x[order[l]] - x[order[k]] > farthest_worth(first)) break;
        const std::size_t i = std::min(order[k], order[l]), j = std::max(order[k], order[l]);
        if (const double within = between(i, j, first.within); within < first.within)
          first = {Promise::fits, within, {i, j}, {}};
      }
  }

  double between(std::size_t i, std::size_t j, double most) const {
    const double room = std::max(0.0, stands_.room_between(robots_[i], robots_[j]));
    const RobotDrift &a = drifts_[i], &b = drifts_[j];
    const double arm =
        std::max(stands_.robot().radius + stands_.robot().reach, stands_.robot().depth);
    // Past bends an arm swings by at most twice its length.
    if (room == infinite || (a.is_fixed() && b.is_fixed()) || room >= 2 * (most + 2 * arm))
      return infinite;
    const double straight = a.is_fixed() || b.is_fixed() ? room : room / 2;
    return last_that(straight, [&](double error) {
      return a.way(arm, error) + b.way(arm, error) <= room * (1 + 1e-15);
    });
  }

  const Polygon& polygon_;
  const Stands& stands_;
  std::vector<LiftingPoint> robots_;
  const std::vector<RobotDrift>& drifts_;
};

std::optional<First> until_misfit(const Placement& placement, const Report& known,
                                  const std::vector<RobotDrift>& drifts) {
  if (!placement.stands || !known.misfits.empty()) return std::nullopt;
  return Room(placement, drifts).first();
}

// H moves by no more than its robots.
std::optional<First> until_tipping(const Placement& placement, const Report& known,
                                   const std::vector<RobotDrift>& drifts) {
  const auto& line = known.tipping_line;
  if (!line || known.tips) return std::nullopt;
  if (std::all_of(drifts.begin(), drifts.end(), [](const auto& each) { return each.is_fixed(); }))
    return std::nullopt;
  const double left = std::max(0.0, line->distance - known.effect.reach);
  const double depth = placement.settings.robot.depth;
  const double within = last_that(left, [&](double error) {
    return std::all_of(drifts.begin(), drifts.end(),
                       [&](const RobotDrift& each) { return each.way(depth, error) <= left; });
  });
  return First{Promise::stands, within, {line->robots[0], line->robots[1]}, {}};
}

std::optional<First> until_loose(const Placement& placement) {
  const Closure& closure = placement.closure;
  const double within = closure.clearance.tolerance;
  if (!closure.form_closure || within == infinite) return std::nullopt;
  First first{Promise::hold, within, {}, {}};
  const double near = near_distance(placement.polygon().diameter());
  for (const Contact& contact : contacts(placement.polygon(), contact_points(placement)))
    if (std::fabs(contact.to_corner - within) <= near &&
        (first.robots.empty() || first.robots.back() != contact.point))
      first.robots.push_back(contact.point);
  return first;
}

// The loads with robots that are off, against the capacities.
class Overload {
 public:
  Overload(const ShownPlacement& of, const Report& known, const std::vector<RobotDrift>& drifts)
      : of_(of),
        known_(known),
        size_(of.placement.polygon().diameter()),
        robots_(positions(lifting_points(of.placement.teams))),
        by_springs_(of.placement.settings.method == Method::given),
        planned_(planned_loads(of.placement.teams)),
        errors_(robots_, of.placement.centre_of_mass,
                known_size(robots_, of.placement.centre_of_mass, size_), of.placement.weight(),
                planned_, !by_springs_, error_directions(of.placement, drifts)) {
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      ends_.push_back(known.planned[i].greatest);
      limits_.push_back(known.limits.empty() ? infinite : known.limits[i].value_or(infinite));
    }
  }

  bool is_overloaded() const { return !known_.overloaded_as_planned.empty(); }

  // The greatest load if all robots are off by `error`: of those that are greatest to first order,
  // also computed again.
  Accuracy::Greatest greatest(double error) const {
    std::vector<double> linear;
    for (std::size_t i = 0; i < robots_.size(); ++i)
      linear.push_back(ends_[i] + error * errors_.sum(i));
    const auto order = sorted_indices(
        linear.size(), [&](std::uint32_t a, std::uint32_t b) { return linear[a] > linear[b]; });
    Accuracy::Greatest greatest{order.front(), linear[order.front()]};
    for (std::size_t k = 0; k < order.size() && k < most_exact; ++k) {
      const std::size_t i = order[k];
      const Points errors = worse(i, error, errors_.worst_errors(i));
      const double load = ends_[i] - planned_[i] + this->load(i, error, errors);
      if (load > greatest.load && std::isfinite(load)) greatest = {i, load};
    }
    return greatest;
  }

  // First to first order, then again for those that are first by that.
  std::optional<First> first() const {
    std::vector<double> linear(robots_.size(), infinite);
    for (std::size_t i = 0; i < robots_.size(); ++i)
      if (limits_[i] < infinite)
        if (const double sum = errors_.sum(i); sum > 0)
          linear[i] = std::max(0.0, limits_[i] - ends_[i]) / sum;
    const auto order = sorted_indices(
        linear.size(), [&](std::uint32_t a, std::uint32_t b) { return linear[a] < linear[b]; });
    First first{Promise::capacity, infinite, {}, {}};
    for (std::size_t k = 0; k < order.size() && linear[order[k]] < infinite; ++k) {
      const std::size_t i = order[k];
      const double within = k < most_exact ? until_overloaded(i, linear[i]) : linear[i];
      if (within < first.within) first = {Promise::capacity, within, {i}, {}};
    }
    if (first.robots.empty()) return std::nullopt;
    return first;
  }

 private:
  static constexpr std::size_t most_exact = 16, most_turned = 64;

  // With the errors that are worst to first order, and then with those that are worse so far off.
  double until_overloaded(std::size_t i, double most) const {
    const auto within = [&](double high, const Points& errors) {
      return last_that(high, [&](double error) {
        return ends_[i] - planned_[i] + load(i, error, errors) <= limits_[i] * (1 + tau);
      });
    };
    const Points errors = errors_.worst_errors(i);
    const double first = within(most, errors);
    return within(first, worse(i, first, errors));
  }

  // Turns errors round, one at a time, as long as that raises the load.
  Points worse(std::size_t i, double error, Points errors) const {
    if (errors.size() > most_turned) return errors;
    double greatest = load(i, error, errors);
    bool turned = true;
    for (int pass = 0; turned && pass < 4; ++pass) {
      turned = false;
      for (std::size_t j = 0; j < errors.size(); ++j) {
        const Vec2 before = errors[j];
        errors[j] = errors_.other_way(j, before);
        if (const double load = this->load(i, error, errors); load > greatest) {
          greatest = load;
          turned = true;
        } else {
          errors[j] = before;
        }
      }
    }
    return errors;
  }

  double load(std::size_t i, double error, const Points& errors) const {
    Points places = robots_;
    for (std::size_t j = 0; j < places.size(); ++j) places[j] += error * errors[j];
    if (!by_springs_) return errors_.planned_at(places)[i];
    const auto springs =
        spring_loads(places, of_.placement.centre_of_mass, size_, of_.placement.weight());
    return springs ? springs->loads[i] : infinite;
  }

  const ShownPlacement& of_;
  const Report& known_;
  double size_;
  Points robots_;
  bool by_springs_;
  std::vector<double> planned_;
  LoadErrors errors_;
  std::vector<double> ends_, limits_;  // the greatest loads without errors, and the capacities
};

std::optional<First> until_overload(const Report& known, const Overload& overload) {
  if (known.capacities.empty() || overload.is_overloaded()) return std::nullopt;
  return overload.first();
}

}  // namespace

std::string_view name(Promise promise) {
  constexpr std::array<std::string_view, promise_count> names{"fits", "stands", "hold", "capacity"};
  return names[static_cast<std::size_t>(promise)];
}

namespace {

// Costs O(m^2 + m h) for m robots of up to 1,000, of which a few are computed again some 50 times, and
// O(m) for more; with bodies O(m^2). All but the radius of C and a further load is known.
Accuracy accuracy_of(const ShownPlacement& of, const Report& known) {
  const Placement& placement = of.placement;
  Accuracy accuracy;
  accuracy.asked = placement.settings.accuracy.value_or(0);
  if (placement.teams.empty()) return accuracy;
  const std::vector<RobotDrift> drifts = drifts_of(placement);
  for (std::size_t i = 0; i < drifts.size(); ++i)
    if (drifts[i].is_fixed()) accuracy.in_notches.push_back(i);
  const double near = near_distance(placement.polygon().diameter());
  const auto add = [&](std::optional<First> first) {
    if (!first) return;
    accuracy.within[static_cast<std::size_t>(first->what)] = first->within;
    if (!accuracy.first || first->within < accuracy.first->within - near)
      accuracy.first = std::move(first);
  };
  add(until_misfit(placement, known, drifts));
  add(until_tipping(placement, known, drifts));
  add(until_loose(placement));
  if (!placement.loads || known.tips) return accuracy;
  if (known.capacities.empty() && !(accuracy.asked > 0)) return accuracy;
  const Overload overload(of, known, drifts);
  add(until_overload(known, overload));
  if (accuracy.asked > 0) accuracy.greatest = overload.greatest(accuracy.asked);
  return accuracy;
}

double near(const ShownPlacement& of) { return near_distance(of.placement.polygon().diameter()); }

// The edge of the lifting base nearest to C.
std::optional<TippingLine> tipping_line(const Placement& placement, double distance) {
  if (!placement.loads) return std::nullopt;
  const Points robots = positions(lifting_points(placement.teams));
  const auto robot_at = [&](const Vec2& corner) {
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < robots.size(); ++i)
      if (squared_length(robots[i] - corner) < squared_length(robots[nearest] - corner))
        nearest = i;
    return nearest;
  };
  const Points& base = placement.lifting_base;
  TippingLine line;
  line.distance = distance;
  if (base.size() < 3) {
    if (!base.empty()) line.robots = {robot_at(base.front()), robot_at(base.back())};
    return line;
  }
  std::size_t least = 0;
  const auto to_edge = [&](std::size_t i) {
    const Vec2 &a = base[i], &b = base[(i + 1) % base.size()];
    return orient(a, b, placement.centre_of_mass) / length(b - a);
  };
  for (std::size_t i = 1; i < base.size(); ++i)
    if (to_edge(i) < to_edge(least)) least = i;
  line.robots = {robot_at(base[least]), robot_at(base[(least + 1) % base.size()])};
  std::sort(line.robots.begin(), line.robots.end());
  return line;
}

bool is_upright(const ShownPlacement& of, const Report& known) {
  if (!known.tipping_line || known.tips) return false;
  const double inside = std::max(hold_requirements(of.placement).inside,
                                 known.effect.reach + of.placement.settings.accuracy.value_or(0));
  return known.tipping_line->distance >= inside - near(of);
}

void add_standing(Report& report, const ShownPlacement& of) {
  const Placement& placement = of.placement;
  report.disturbance = disturbance_of(of.shown);
  report.effect = effect_on(of);
  report.equilibrium = equilibrium(placement);
  report.robustness = robustness(placement);
  const double size = placement.polygon().diameter(), tips_at = report.robustness.tipping_distance;
  report.tips = !is_within_base(report.effect.reach, tips_at, size);
  report.tilt = tilt_of(report.disturbance, report.effect, tips_at, size);
  if (report.tilt && !placement.loads) report.tilt->stays = false;  // falls on level ground
  report.tipping_line = tipping_line(placement, tips_at);
  report.upright = is_upright(of, report);
  report.firm = hold_firmly(placement);
  report.held = is_held(placement);
  report.misfits = misfits(placement);
}

void add_models(Report& report, const ShownPlacement& of) {
  if (!report.models) report.models = model_loads(of.placement, report.disturbance);
}

std::vector<double> greatest_of(const std::vector<LoadRange>& loads) {
  std::vector<double> greatest;
  for (const LoadRange& load : loads) greatest.push_back(load.greatest);
  return greatest;
}

void tell_overloads(Report& report, const ShownPlacement& of) {
  report.greatest = 0;
  for (const LoadRange& load : report.loads)
    report.greatest = std::max(report.greatest, load.greatest);
  report.overloaded = overloaded_robots(of, greatest_of(report.loads));
}

// By the model that is shown.
void tell(Report& report, const ShownPlacement& of, LoadModel model) {
  report.known.model = model;
  report.model = report.models ? model : LoadModel::plan;
  report.loads = report.model == LoadModel::plan
                     ? report.planned
                     : shown_loads(of.placement, report.model, report.models, report.tips);
  tell_overloads(report, of);
}

// Loads beyond rounding are at least 0.
void add_capacities(Report& report, const ShownPlacement& of) {
  if (!report.has_capacities) return;
  report.capacities = capacities_of(of);
  report.limits = limits_of(of);
  for (std::size_t i = 0; i < report.limits.size() && i < report.planned.size(); ++i)
    report.use.push_back(of.placement.loads && !report.tips && report.limits[i]
                             ? std::optional(report.planned[i].greatest / *report.limits[i])
                             : std::nullopt);
}

void add_loads(Report& report, const ShownPlacement& of, LoadModel model) {
  if (report.disturbance.any() || model != LoadModel::plan) add_models(report, of);
  const auto& conditions = report.disturbance.any() ? report.models : std::nullopt;
  report.planned = shown_loads(of.placement, LoadModel::plan, conditions, report.tips);
  report.loads_are_determined = loads_are_determined(of.placement);
  report.worst = worst_loads(of.placement, report.effect);
  add_capacities(report, of);
  if (report.worst) report.overloaded_at_worst = overloaded_robots(of, *report.worst);
  report.overloaded_as_planned = overloaded_robots(of, greatest_of(report.planned));
  report.overloaded_at_rest = overloaded_robots(of);
  tell(report, of, model);
}

// The changes of loads by everything but the error of C.
LoadChanges changes_besides_com(const Report& report, const ShownPlacement& of) {
  if (!report.disturbance.besides_com()) return {};
  if (report.disturbance.com_radius == 0) return report.models->changes;
  Disturbance besides = report.disturbance;
  besides.com_radius = 0;
  const auto models = model_loads(of.placement, besides);
  return models ? models->changes : LoadChanges{};
}

void add_com_radius(Report& report, const ShownPlacement& of) {
  if (report.com_radius || !report.models || report.capacities.empty()) return;
  const LoadChanges changes = changes_besides_com(report, of);
  const auto within = [&](const std::vector<std::optional<double>>& limits) {
    return radius_within_capacity(report.models->springs, report.robustness.tipping_distance,
                                  limits, changes);
  };
  const std::vector<std::optional<double>> no_limits(report.capacities.size());
  report.com_radius = {within(report.limits), within(no_limits)};
}

Report::Effective effective(const Placement& placement) {
  const Settings& settings = placement.settings;
  const Polygon& polygon = placement.polygon();
  return {hold_requirements(placement).clear,
          settings.apart.value_or(usual_apart *
                                  farthest_vertex(placement.object, placement.centre_of_mass)),
          settings.snap.value_or(usual_snap * polygon.diameter())};
}

}  // namespace

std::optional<std::size_t> Report::most_used() const {
  std::optional<std::size_t> most;
  for (std::size_t i = 0; i < use.size(); ++i)
    if (use[i] && (!most || *use[i] > *use[*most])) most = i;
  return most;
}

Report report_of(const ShownPlacement& of, const Asked& asked) {
  Report report;
  report.has_capacities = has_capacities(of);
  report.has_own_capacities = has_own_capacities(of);
  report.effective = effective(of.placement);
  if (const auto& weighing = of.placement.weighing)
    report.readings_fit = fit_of(*weighing, of.shown.carrying);
  if (!of.placement.teams.empty()) {
    add_standing(report, of);
    add_loads(report, of, asked.model);
    report.accuracy = accuracy_of(of, report);
    report.extra = extra_load(of);
  }
  complete(report, of, asked);
  return report;
}

void complete(Report& report, const ShownPlacement& of, const Asked& asked) {
  if (asked.plans && report.has_capacities) {
    std::optional<double> limit;
    if (of.shown.capacity) limit = limit_of(*of.shown.capacity, of.shown.carrying);
    if (!report.plan) report.plan = limit ? plan_capacity(of.placement, *limit) : CapacityPlan{};
    if (!report.if_one_fails)
      report.if_one_fails = limit ? plan_for_failures(of, *limit) : FailurePlan{};
  }
  const bool has_robots = !of.placement.teams.empty();
  if (has_robots) {
    if (asked.models || asked.model != LoadModel::plan) add_models(report, of);
    if (asked.model != report.known.model) tell(report, of, asked.model);
    add_com_radius(report, of);
    if (asked.models && report.models && !report.inexact_models)
      report.inexact_models = with_inaccuracy(*report.models, of.placement);
  }
  if (asked.failures && has_robots && report.failures.empty()) {
    report.failures = single_failures(of.placement, report.disturbance);
    if (report.has_capacities) report.overloaded_after = overloaded_after(of, report.failures);
  }
  report.known.models |= asked.models;
  report.known.failures |= asked.failures;
  report.known.plans |= asked.plans;
}

Report report_of_failure(const ShownPlacement& failing, std::size_t robot,
                         const std::optional<RestOfRobots>& rest, std::vector<LoadRange> loads) {
  Report report;
  report.has_capacities = has_capacities(failing);
  report.has_own_capacities = has_own_capacities(failing);
  add_standing(report, failing);
  report.tips = rest && !rest->stays;
  report.planned = loads_by(LoadModel::plan, failing.placement, std::nullopt);
  add_capacities(report, failing);
  report.model = LoadModel::springs;
  report.loads = loads.empty() ? report.planned : std::move(loads);
  tell_overloads(report, failing);
  report.overloaded_as_planned = report.overloaded;
  report.accuracy = accuracy_of(failing, report);
  report.failed = robot;
  return report;
}

}  // namespace evenlift
