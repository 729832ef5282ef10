// The number of robots needed if the load of each is limited (thesis 1, 5.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/failures.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"

namespace evenlift {

// The value of most_teams_tried() if teams are not swapped.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

// The most teams that a plan tries: most_swapped_teams (swaps.h) if teams are swapped until they
// hold, otherwise most_teams_for_capacity. O(1).
std::uint32_t most_teams_tried(const Settings& settings);

// The capacity of a robot: a given support's own capacity, or else the common one; nothing if
// neither is given. Robots are numbered as in find_robot() (loads.h). O(1).
std::optional<double> capacity_of(const ShownPlacement& of, std::size_t robot);

// The load without dynamic effects that a robot with this capacity may be expected to carry: the
// capacity divided by Carrying::load_factor(). Loads are compared with this. O(1).
double limit_of(double capacity, const Carrying& carrying);

// has_capacities() returns whether any robot has a capacity, and has_own_capacities() whether given
// supports have their own. O(1).
bool has_capacities(const ShownPlacement& of);
bool has_own_capacities(const ShownPlacement& of);

// The numbers of the robots whose loads exceed what they may carry (limit_of()). The first function
// takes the planned loads, the second the given `loads`. O(robots).
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of);
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of,
                                           const std::vector<double>& loads);

// capacities_of() returns the result of capacity_of() for each robot, and limits_of() that of
// limit_of(). O(robots).
std::vector<std::optional<double>> capacities_of(const ShownPlacement& of);
std::vector<std::optional<double>> limits_of(const ShownPlacement& of);

// Whether any robot's load by springs may exceed the robot's capacity after a failure, within the
// disturbance (uncertainty.h) for which `rest` was computed. False if the other robots do not carry
// the object, or if it tips under these conditions. overloaded_after() returns these robots for each
// failure. O(m) for each failure.
bool overloads(const ShownPlacement& of, const std::optional<RestOfRobots>& rest);
std::vector<std::vector<std::size_t>> overloaded_after(
    const ShownPlacement& of, const std::vector<std::optional<RestOfRobots>>& failures);

struct CapacityPlan {
  bool possible = false;     // whether some number of teams suffices
  std::uint32_t teams = 0;   // the least such number, if `possible`
  double greatest_load = 0;  // of a robot, if `possible`
  std::uint32_t tried = 0;   // the greatest number of teams tried. If no number of teams of two
                             // suffices and `tried` is below most_teams_tried(), there is no
                             // place for more, check_swaps() (swaps.h) refuses more, or the plan
                             // is cut short
  // The number of robots in a team. All balanced robots form one team; if no number of them
  // suffices, this is most_robots.
  std::uint32_t team_size = 2;
  bool cut_short = false;  // whether most_work_planned ended the plan
  bool operator==(const CapacityPlan&) const = default;
};

// A plan for which each number of robots needs a search of its own tries no more numbers once these
// searches have taken this part of the work that one search may take (BalancedWork in
// balanced.h, most_swap_steps in swaps.h).
inline constexpr double most_work_planned = 0.5;

// Makes a plan for the object of `placement`, a result of place(), with its candidates. Each robot
// carries up to `capacity` > 0, in the unit of the weight: what limit_of() returns. The plan depends
// on the polygon, the holes, the centre of mass, and all settings that affect loads except the number
// of teams or robots.
//
// Without swaps, the methods `area`, `circle`, `distance` and `random` choose teams one after
// another. So the first k teams of a selection are a placement of k teams, and a plan costs as much
// as selecting the needed teams. With equal angles, each number of teams has its own places; for
// each number, the plan computes loads only, up to the first overloaded robot. If teams are
// swapped, each number of teams also has its own places, and needs its own swaps, up to
// most_work_planned. The least number of balanced robots follows from the weight, the capacity and
// the failures to survive; the plan does not check whether such a set exists. For given supports no
// plan is possible.
CapacityPlan plan_capacity(const Placement& placement, double capacity);

// The number of robots needed if any one robot may fail, under the given conditions
// (disturbance_of() of tilt.h). While all robots work, no planned load exceeds the capacity. After
// one has failed, no load by springs (load_models.h) exceeds the capacity, and C is at least `clear`
// (document.h), and at least the reach of the conditions, inside the hull of the others. The ends of
// ranges count for loads. exceeds() (tolerance.h) decides them. The plan does not consider that
// loads swing if a robot fails suddenly.
struct FailurePlan {
  bool possible = false;
  // Whether no such number was found, but one with which only the loads are within the capacity.
  bool can_tip = false;
  std::uint32_t robots = 0;  // the least such number, if `possible` or `can_tip`
  double greatest_load = 0;  // with this number: of a robot, before or after any one failure
  std::uint32_t tried = 0;   // the greatest number of robots tried; 0 if none was
  bool operator==(const FailurePlan&) const = default;
};

// Finds the least number of robots for the placement's method, at the places where place() would
// put them. The search begins with the least number that the weight and, for balanced robots, the
// setting `survive` permit. It ends when there is no place for more teams, when check_swaps()
// (swaps.h) refuses more, or after most_teams_tried() teams (for balanced robots, after
// most_robots). It also ends before it would compute more loads in all than `most_loads_planned`; m
// robots need m^2, and m^3 if heights are off. For balanced robots it tries at most
// `most_sets_planned` different numbers, each with a whole search. Searches and swaps together are
// limited by most_work_planned. For given supports no plan is possible.
inline constexpr std::uint64_t most_loads_planned = std::uint64_t{1} << 21;
inline constexpr std::uint32_t most_sets_planned = 8;
FailurePlan plan_for_failures(const ShownPlacement& of, double capacity);

// Whether two placements agree in everything on which plans depend. O(n).
bool same_plan(const Placement& a, const Placement& b);

}  // namespace evenlift
