#include "evenlift/capacity.h"

#include <algorithm>
#include <cmath>

#include "evenlift/balanced.h"
#include "evenlift/hull.h"
#include "evenlift/load_models.h"
#include "evenlift/selection.h"
#include "evenlift/settings.h"
#include "evenlift/swaps.h"
#include "evenlift/tilt.h"
#include "evenlift/tolerance.h"
#include "evenlift/uncertainty.h"
#include "selection/equal_angles.h"
#include "selection/greedy_selector.h"

namespace evenlift {
namespace {

std::uint32_t number_of_teams(double value) {
  return static_cast<std::uint32_t>(
      std::clamp(std::ceil(value), 1.0, static_cast<double>(most_teams_for_capacity)));
}

// A robot of even teams carries weight / (2 teams), so fewer teams are never enough.
std::uint32_t least_teams(double weight, double capacity) {
  return number_of_teams(weight / (2 * capacity * (1 + tau)));
}

// The greater load's share of a team's load.
double greater_share(const Chord& chord) {
  return std::max(chord.arm1, chord.arm2) / (chord.arm1 + chord.arm2);
}

// For methods that choose teams one after another. The number of teams changes a team's weight, but
// not how its robots share it: the most uneven team so far has the greatest load.
class Growing {
 public:
  Growing(double weight, double capacity) : weight_(weight), capacity_(capacity) {}

  // Returns whether the teams now suffice.
  bool add(const Chord& chord) {
    share_ = std::max(share_, greater_share(chord));
    const double greatest = weight_ / ++plan_.tried * share_;
    if (!exceeds(greatest, capacity_)) plan_ = {true, plan_.tried, greatest, plan_.tried, 2};
    return plan_.possible;
  }

  const CapacityPlan& plan() const { return plan_; }

 private:
  double weight_, capacity_;
  double share_ = 0.5;
  CapacityPlan plan_;
};

CapacityPlan plan_by_candidates(const Placement& placement, double capacity) {
  Growing growing(placement.weight(), capacity);
  Selector selector(placement.object, placement.centre_of_mass, placement.candidates,
                    *metric_of(placement.settings.method), first_team(placement.settings.positions),
                    placement.stands.get());
  while (growing.plan().tried < most_teams_for_capacity && selector.take_next())
    if (growing.add(placement.candidates[selector.taken().back()].chord)) break;
  return growing.plan();
}

// The most teams with which swapping can start. Robots with a size may have room for fewer.
std::uint32_t most_with_room(const Placement& placement) {
  const std::size_t most =
      std::min<std::size_t>(placement.candidates.size(), most_teams_tried(placement.settings));
  if (!placement.stands) return static_cast<std::uint32_t>(most);
  return static_cast<std::uint32_t>(
      select_teams(placement.object, placement.centre_of_mass, placement.candidates,
                   *metric_of(placement.settings.method), most,
                   first_team(placement.settings.positions), placement.stands.get())
          .size());
}

// With swaps, each number of teams has its own choice.
CapacityPlan plan_by_swap(const Placement& placement, double capacity) {
  const double weight = placement.weight();
  const auto& candidates = placement.candidates;
  const std::uint32_t most = most_with_room(placement);
  double work = 0;
  for (std::uint32_t teams = least_teams(weight, capacity); teams <= most; ++teams) {
    if (check_swaps(candidates.size(), teams, placement.stands.get()))
      return {false, 0, 0, teams - 1, 2};
    const ChosenTeams chosen =
        choose_candidates(placement.object, placement.centre_of_mass, candidates,
                          placement.settings, teams, placement.stands.get());
    double greatest = 0;
    for (const std::uint32_t i : chosen.taken)
      greatest = std::max(greatest, weight / teams * greater_share(candidates[i].chord));
    if (!exceeds(greatest, capacity)) return {true, teams, greatest, teams, 2};
    work += chosen.work;
    if (work > most_work_planned) return {false, 0, 0, teams, 2, teams < most};
  }
  return {false, 0, 0, most, 2};
}

CapacityPlan plan_at_random(const Placement& placement, double capacity) {
  const Settings& settings = placement.settings;
  Growing growing(total_weight(settings), capacity);
  // No robot carries more than its team, so this number is enough if it can be placed.
  const std::uint32_t enough = number_of_teams(total_weight(settings) / capacity + 1);
  for (const Chord& chord :
       random_teams(placement.polygon(), placement.centre_of_mass, enough, settings.seed))
    if (growing.add(chord)) break;
  return growing.plan();
}

// The least number of teams in [first, end) within the capacity.
CapacityPlan plan_among(const EqualAngles& angles, double weight, double capacity,
                        std::uint32_t first, std::uint32_t end) {
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t teams = first; teams < end; ++teams) numbers.push_back(teams);
  std::vector<double> greatest(numbers.size(), 0);
  angles.for_each_chord(numbers, [&](std::size_t i, const Chord& chord) {
    greatest[i] = std::max(greatest[i], weight / numbers[i] * greater_share(chord));
    return !exceeds(greatest[i], capacity);
  });
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (!exceeds(greatest[i], capacity)) return {true, numbers[i], greatest[i], numbers[i], 2};
  return {false, 0, 0, end - 1, 2};
}

CapacityPlan plan_at_equal_angles(const Placement& placement, double capacity) {
  const EqualAngles angles(placement.polygon(), placement.centre_of_mass);
  if (!angles.has_chords()) return {};
  const double weight = placement.weight();
  // One sweep tries several numbers; beginning with few wastes little.
  std::uint32_t first = least_teams(weight, capacity), numbers = 8;
  for (;; numbers *= 2) {
    const std::uint32_t end = std::min(first + numbers, most_teams_for_capacity + 1);
    const CapacityPlan plan = plan_among(angles, weight, capacity, first, end);
    if (plan.possible || end > most_teams_for_capacity) return plan;
    first = end;
  }
}

CapacityPlan plan_balanced(const Settings& settings, double capacity) {
  std::uint32_t robots = settings.survive > 0 ? 2 * settings.survive + 3 : least_robots;
  const auto load = [&] { return total_weight(settings) / robots; };
  while (robots < most_robots && exceeds(load(), capacity)) ++robots;
  if (exceeds(load(), capacity)) return {false, 0, 0, 1, most_robots};
  return {true, 1, load(), 1, robots};
}

}  // namespace

std::optional<double> capacity_of(const ShownPlacement& of, std::size_t robot) {
  const auto& own = of.shown.support_capacities;
  const std::size_t support = of.placement.support_of(robot);
  return has_own_capacities(of) && support < own.size() && own[support] ? own[support]
                                                                        : of.shown.capacity;
}

double limit_of(double capacity, const Carrying& carrying) {
  return capacity / carrying.load_factor();
}

bool has_capacities(const ShownPlacement& of) {
  return of.shown.capacity || has_own_capacities(of);
}

bool has_own_capacities(const ShownPlacement& of) {
  return of.placement.settings.method == Method::given && !of.shown.support_capacities.empty();
}

std::vector<std::size_t> overloaded_robots(const ShownPlacement& of) {
  return overloaded_robots(of, planned_loads(of.placement.teams));
}

std::vector<std::size_t> overloaded_robots(const ShownPlacement& of,
                                           const std::vector<double>& loads) {
  std::vector<std::size_t> robots;
  for (std::size_t robot = 0; robot < loads.size(); ++robot)
    if (const auto capacity = capacity_of(of, robot);
        capacity && exceeds(loads[robot], limit_of(*capacity, of.shown.carrying)))
      robots.push_back(robot);
  return robots;
}

std::vector<std::optional<double>> capacities_of(const ShownPlacement& of) {
  std::vector<std::optional<double>> capacities;
  for (std::size_t robot = 0; robot < count_robots(of.placement.teams); ++robot)
    capacities.push_back(capacity_of(of, robot));
  return capacities;
}

std::vector<std::optional<double>> limits_of(const ShownPlacement& of) {
  std::vector<std::optional<double>> limits = capacities_of(of);
  for (std::optional<double>& each : limits)
    if (each) each = limit_of(*each, of.shown.carrying);
  return limits;
}

bool overloads(const ShownPlacement& of, const std::optional<RestOfRobots>& rest) {
  return !overloaded_after(of, {rest}).front().empty();
}

std::vector<std::vector<std::size_t>> overloaded_after(
    const ShownPlacement& of, const std::vector<std::optional<RestOfRobots>>& failures) {
  std::vector<std::vector<std::size_t>> after(failures.size());
  for (std::size_t i = 0; i < failures.size(); ++i)
    if (failures[i] && failures[i]->stays) after[i] = overloaded_robots(of, failures[i]->ends);
  return after;
}

bool same_plan(const Placement& a, const Placement& b) {
  const auto settings_of = [](const Placement& of) {
    return Document{{}, of.centre_of_mass, of.settings};
  };
  return a.vertices() == b.vertices() && a.centre_of_mass == b.centre_of_mass &&
         a.object.rings_of_holes() == b.object.rings_of_holes() &&
         alike(settings_of(a), settings_of(b), &SettingRow::plans);
}

std::uint32_t most_teams_tried(const Settings& settings) {
  return swaps_teams(settings) ? most_swapped_teams : most_teams_for_capacity;
}

CapacityPlan plan_capacity(const Placement& placement, double capacity) {
  switch (placement.settings.method) {
    case Method::distributed:
      return plan_at_equal_angles(placement, capacity);
    case Method::balanced:
      return plan_balanced(placement.settings, capacity);
    case Method::random:
      return plan_at_random(placement, capacity);
    case Method::given:  // more robots would need more places
      return {};
    case Method::area:
    case Method::circle:
    case Method::distance:
      break;
  }
  return swaps_teams(placement.settings) ? plan_by_swap(placement, capacity)
                                         : plan_by_candidates(placement, capacity);
}

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
