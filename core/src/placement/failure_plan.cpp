#include <algorithm>
#include <cmath>

#include "evenlift/balanced.h"
#include "evenlift/capacity.h"
#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/selection.h"
#include "evenlift/swaps.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "evenlift/uncertainty.h"

namespace evenlift {
namespace {

// Places any number of robots by the placement's method.
class Placer {
 public:
  explicit Placer(const Placement& placement) : placement_(placement) {}

  bool is_balanced() const { return placement_.settings.method == Method::balanced; }

  // Of all searches so far, in limits of one.
  double work() const { return work_; }

  // Empty if the method cannot place this number.
  std::vector<Team> teams(std::uint32_t robots) {
    const Settings& settings = placement_.settings;
    const std::size_t number = robots / 2;
    std::vector<Chord> chords;
    switch (settings.method) {
      case Method::distributed:
        chords = distributed_teams(placement_.polygon(), placement_.centre_of_mass, number);
        break;
      case Method::random:
        chords =
            random_teams(placement_.polygon(), placement_.centre_of_mass, number, settings.seed);
        break;
      case Method::balanced:
        return balanced(robots);
      case Method::given:
        return {};
      case Method::area:
      case Method::circle:
      case Method::distance:
        chords = chords_of(placement_.candidates, chosen(number));
    }
    if (chords.size() < number) return {};
    return distribute_weight(chords, total_weight(settings));
  }

 private:
  std::vector<Team> balanced(std::uint32_t robots) {
    Settings settings = placement_.settings;
    settings.robots = robots;
    const BalancedProblem problem(placement_.object, placement_.centre_of_mass, settings);
    auto search = start_balanced(problem);
    if (!search) return {};
    const BalancedSearch end = finish_search(problem, *std::move(search));
    work_ += work_used(problem, end);
    return {share_evenly(end.robots, placement_.centre_of_mass, total_weight(settings))};
  }

  // Without swaps, a smaller choice is the beginning of a larger one.
  std::vector<std::uint32_t> chosen(std::size_t number) {
    const bool swapped = swaps_teams(placement_.settings);
    if (swapped || chosen_.size() < number) {
      ChosenTeams teams = choose_candidates(placement_.object, placement_.centre_of_mass,
                                            placement_.candidates, placement_.settings,
                                            swapped ? number : 2 * number, placement_.stands.get());
      chosen_ = std::move(teams.taken);
      work_ += teams.work;
    }
    return {chosen_.begin(),
            chosen_.begin() + static_cast<std::ptrdiff_t>(std::min(number, chosen_.size()))};
  }

  const Placement& placement_;
  std::vector<std::uint32_t> chosen_;
  double work_ = 0;
};

// Robots at their places, under the given conditions.
class PlannedCrew {
 public:
  PlannedCrew(const ShownPlacement& of, const std::vector<Team>& teams)
      : of_(of),
        conditions_(disturbance_of(of.shown)),
        planned_(planned_loads(teams)),
        all_(positions(lifting_points(teams))) {}

  // The greatest load, intact or after any one failure; nullopt if the object then falls, or if the
  // load exceeds the capacity. `upright` becomes whether the object stays clearly upright, intact
  // and after any failure.
  std::optional<double> greatest_of_all(double capacity, bool& upright) const {
    double greatest = greatest_load(
        all_, planned_, conditions_.any() ? springs_of(all_) : std::nullopt, conditions_);
    upright = true;
    const Disturbance rest = after_failure(conditions_, all_.size());
    for (std::size_t failed = 0; failed < all_.size() && !exceeds(greatest, capacity); ++failed) {
      Points others = all_;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(failed));
      const auto springs = springs_of(others);
      if (!springs) return std::nullopt;
      upright = upright && is_upright(others, rest);
      greatest = std::max(greatest, greatest_load(others, springs->loads, springs, rest));
    }
    return exceeds(greatest, capacity) ? std::nullopt : std::optional(greatest);
  }

 private:
  double diameter() const { return of_.placement.polygon().diameter(); }
  const Vec2& centre() const { return of_.placement.centre_of_mass; }

  std::optional<SpringLoads> springs_of(const Points& robots) const {
    return spring_loads(robots, centre(), diameter(), of_.placement.weight());
  }

  // Of robots that carry these loads, under the disturbance. If it tips, only the loads at rest are
  // known.
  double greatest_load(const Points& robots, const std::vector<double>& loads,
                       const std::optional<SpringLoads>& springs,
                       const Disturbance& disturbance) const {
    const bool changes = disturbance.any() && springs && stays(robots, disturbance);
    const std::vector<double> ends =
        changes ? greatest_loads(robots, centre(), diameter(), of_.placement.weight(), loads,
                                 *springs, disturbance)
                : loads;
    return *std::max_element(ends.begin(), ends.end());
  }

  double tipping_distance_of(const Points& robots) const {
    return tipping_distance(convex_hull(robots, near_distance(diameter())), centre(), diameter());
  }

  bool stays(const Points& robots, const Disturbance& disturbance) const {
    return is_within_base(effect_on(robots, centre(), diameter(), disturbance).reach,
                          tipping_distance_of(robots), diameter());
  }

  bool is_upright(const Points& robots, const Disturbance& disturbance) const {
    const double distance = tipping_distance_of(robots);
    return distance > 0 &&
           distance >= hold_requirements(of_.placement).inside - near_distance(diameter()) &&
           is_within_base(effect_on(robots, centre(), diameter(), disturbance).reach +
                              of_.placement.settings.accuracy.value_or(0),
                          distance, diameter());
  }

  const ShownPlacement& of_;
  Disturbance conditions_;
  std::vector<double> planned_;
  Points all_;
};

// After one failure, equal loads are weight / (robots - 1).
std::uint32_t least_that_may_do(const Settings& settings, double capacity, std::uint32_t most) {
  const double number = std::ceil(total_weight(settings) / (capacity * (1 + tau))) + 1;
  const auto by_weight = static_cast<std::uint32_t>(std::clamp(number, 3.0, most + 1.0));
  const bool balanced = settings.method == Method::balanced;
  if (balanced && settings.survive > 0) return std::max(by_weight, 2 * settings.survive + 3);
  return balanced ? by_weight : by_weight + by_weight % 2;
}

// Whether the object can tip, or stands too near to tipping, even on robots all around it.
bool tips_wherever_they_stand(const ShownPlacement& of) {
  const Placement& placement = of.placement;
  const double size = placement.polygon().diameter();
  Disturbance on_even_ground = disturbance_of(of.shown);
  on_even_ground.uneven = 0;
  const double needed =
      std::max(hold_requirements(placement).inside, effect_on({}, {}, size, on_even_ground).reach +
                                                        placement.settings.accuracy.value_or(0));
  return !is_within_base(
      needed, tipping_distance(convex_hull(placement.vertices()), placement.centre_of_mass, size),
      size);
}

}  // namespace

FailurePlan plan_for_failures(const ShownPlacement& of, double capacity) {
  const Placement& placement = of.placement;
  if (placement.settings.method == Method::given) return {};
  Placer method(placement);
  const bool balanced = method.is_balanced(), uneven = of.shown.carrying.uneven > 0;
  const std::uint32_t most = balanced ? most_robots : 2 * most_teams_tried(placement.settings),
                      step = balanced ? 1 : 2;
  const std::uint32_t least = least_that_may_do(placement.settings, capacity, most);
  const bool hopeless = tips_wherever_they_stand(of);
  FailurePlan plan;
  std::uint64_t loads = 0;
  for (std::uint32_t robots = least; robots <= most; robots += step) {
    if (balanced && robots >= least + most_sets_planned) break;
    loads += std::uint64_t{robots} * robots * (uneven ? robots : 1);
    if (loads > most_loads_planned) break;
    if (swaps_teams(placement.settings) &&
        check_swaps(placement.candidates.size(), robots / 2, placement.stands.get()))
      break;
    const std::vector<Team> teams = method.teams(robots);
    if (teams.empty() && !balanced) break;
    plan.tried = robots;
    if (teams.empty()) continue;
    bool upright = false;
    const auto greatest = PlannedCrew(of, teams).greatest_of_all(capacity, upright);
    if (greatest && upright) return {true, false, robots, *greatest, robots};
    if (greatest && !plan.can_tip) plan = {false, true, robots, *greatest, robots};
    if ((plan.can_tip && hopeless) || method.work() > most_work_planned) break;
  }
  return plan;
}

}  // namespace evenlift
