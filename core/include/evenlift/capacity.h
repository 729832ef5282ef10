// The number of robots that an object needs if the load of each robot is limited (thesis 1, 5.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/failures.h"
#include "evenlift/placed_robots.h"
#include "evenlift/placement.h"

namespace evenlift {

// The greatest number of teams that a plan tries if teams are not swapped.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

// The greatest number of teams that a plan tries with these settings: most_swapped_teams
// (swaps.h) if teams are swapped until they hold, otherwise most_teams_for_capacity. O(1).
std::uint32_t most_teams_tried(const Settings& settings);

// The greatest load that a robot can carry: a given support's own capacity, if it has one,
// otherwise the common one. Nothing if neither is given. Robots are numbered as in find_robot()
// (loads.h). O(1).
std::optional<double> capacity_of(const ShownPlacement& of, std::size_t robot);

// Whether a load exceeds a capacity by more than tau (tolerance.h) times the capacity. Rounding
// alone could add as much as that. O(1).
bool exceeds(double load, double capacity);

// Whether any robot has a capacity, and whether supports have capacities of their own. O(1).
bool has_capacities(const ShownPlacement& of);
bool has_own_capacities(const ShownPlacement& of);

// The robots whose loads, planned or given, exceed their capacities. O(robots).
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of);
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of,
                                           const std::vector<double>& loads);

// The capacity of each robot, or nothing for a robot without one. O(robots).
std::vector<std::optional<double>> capacities_of(const ShownPlacement& of);

// The greatest radius within which C may lie so that, by springs and under the other conditions
// that are given, no robot carries more than its limit (radius_within_capacity() of uncertainty.h).
// Costs as much as model_loads().
std::optional<double> com_radius_within(const ShownPlacement& of, const ModelLoads& loads,
                                        const std::vector<std::optional<double>>& limits);

// Whether any robot may carry more than its capacity after a failure, by springs and within the
// disturbance that `rest` allows for; false if the others do not carry the object. The second
// function does this for each failure. O(m), O(m^2).
bool overloads(const ShownPlacement& of, const std::optional<RestOfRobots>& rest);
std::vector<bool> overloads_after(const ShownPlacement& of,
                                  const std::vector<std::optional<RestOfRobots>>& failures);

struct CapacityPlan {
  bool possible = false;     // whether some number of teams keeps every robot within the capacity
  std::uint32_t teams = 0;   // if possible, the least such number with the placement's method
  double greatest_load = 0;  // if possible, the greatest load of a robot with that number
  std::uint32_t tried = 0;   // the most teams that were tried; for teams of two, a number below
                             // most_teams_tried() without success means that there is no place for
                             // more, or that check_swaps() (swaps.h) refuses more
  // The number of robots in a team. Balanced robots form one team: of the least number of robots
  // if the plan is possible, otherwise of most_robots.
  std::uint32_t team_size = 2;
  bool operator==(const CapacityPlan&) const = default;
};

// Finds the plan for the object of a placement, which must come from place(). Each robot carries up
// to `capacity` > 0, in the unit of the weight. The plan depends on the placement's polygon, holes
// and centre of mass, and on all settings that affect the loads except the number of teams or
// robots; same_plan() compares exactly these inputs. The candidates of the placement are reused.
//
// The methods area, circle, distance and random choose teams one after another, so the first k
// teams of a selection are a placement of k teams. Such a plan costs as much as selecting the teams
// that are needed, at most most_teams_tried(). Teams at equal angles differ for each number of
// teams; only their loads are computed, and a number of teams is rejected at the first overloaded
// robot. Teams that are swapped until they hold also differ for each number of teams, and each
// number costs its own swaps (swaps.h). Balanced robots all carry the same planned load, so their
// least number follows from the weight, the capacity and the number of failures to survive; whether
// such a set exists is not checked. For given supports no plan is possible.
CapacityPlan plan_capacity(const Placement& placement, double capacity);

// The number of robots needed if any one may fail. While all work, no planned load exceeds the
// capacity. After any one has failed, the others carry the object, and no robot carries more than
// the capacity, provided that all are equally stiff and level and the object is rigid
// (load_models.h, springs). Sudden changes of load are not considered (failures.h).
struct FailurePlan {
  bool possible = false;
  std::uint32_t robots = 0;  // if possible, the least sufficient number that was found
  double greatest_load = 0;  // if possible, the greatest load of a robot, whichever one fails
  std::uint32_t tried = 0;   // the greatest number of robots that was tried
  bool operator==(const FailurePlan&) const = default;
};

// Finds the least number of robots for a FailurePlan with the placement's method. They stand where
// place() would put them. The search begins with the least number that the weight and, for balanced
// robots, the setting `survive` permit. It ends where the method finds no place for more, at
// most_teams_tried(), or when the loads of most_loads_planned robots have been computed. For
// balanced robots it tries at most most_sets_planned numbers, each with a whole search
// (balanced.h).
inline constexpr std::uint64_t most_loads_planned = std::uint64_t{1} << 21;
inline constexpr std::uint32_t most_sets_planned = 8;
FailurePlan plan_for_failures(const Placement& placement, double capacity);

// Whether two placements agree in everything on which plans depend, so that their plans are always
// equal. O(n).
bool same_plan(const Placement& a, const Placement& b);

}  // namespace evenlift
