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

// The limit in most_teams_tried() for teams that are not swapped.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

// The most teams that a plan tries: most_swapped_teams (swaps.h) if teams are swapped until they
// hold, otherwise most_teams_for_capacity. O(1).
std::uint32_t most_teams_tried(const Settings& settings);

// The capacity of a robot: a given support's own capacity, or else the common one; nothing if
// neither is given. Robots are numbered as in find_robot() (loads.h). O(1).
std::optional<double> capacity_of(const ShownPlacement& of, std::size_t robot);

// Whether a load exceeds the capacity by more than tau (tolerance.h) times the capacity. Rounding
// alone could add that much. O(1).
bool exceeds(double load, double capacity);

// has_capacities() returns whether any robot has a capacity, has_own_capacities() whether given
// supports have their own. O(1).
bool has_capacities(const ShownPlacement& of);
bool has_own_capacities(const ShownPlacement& of);

// The numbers of the robots whose planned loads, or these `loads`, exceed their capacities.
// O(robots).
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of);
std::vector<std::size_t> overloaded_robots(const ShownPlacement& of,
                                           const std::vector<double>& loads);

// The capacity_of() of each robot. O(robots).
std::vector<std::optional<double>> capacities_of(const ShownPlacement& of);

// The greatest radius within which C may lie so that no robot exceeds its limit, by springs and
// under the other given conditions (radius_within_capacity() of uncertainty.h). Costs as much as
// model_loads().
std::optional<double> com_radius_within(const ShownPlacement& of, const ModelLoads& loads,
                                        const std::vector<std::optional<double>>& limits);

// Whether any robot may exceed its capacity after a failure, by springs and within the disturbance
// that `rest` allows for; false if the other robots do not carry the object. overloads_after()
// answers this for each failure. O(m) for each failure.
bool overloads(const ShownPlacement& of, const std::optional<RestOfRobots>& rest);
std::vector<bool> overloads_after(const ShownPlacement& of,
                                  const std::vector<std::optional<RestOfRobots>>& failures);

struct CapacityPlan {
  bool possible = false;     // whether some number of teams suffices
  std::uint32_t teams = 0;   // if possible, the least such number
  double greatest_load = 0;  // of a robot, if possible
  std::uint32_t tried = 0;   // the most teams tried. If that is below most_teams_tried() and no
                             // number of teams of two suffices, there is no place for more, or
                             // check_swaps() (swaps.h) refuses more
  // Robots in a team. Balanced robots form one team: of the least number if possible, otherwise of
  // most_robots.
  std::uint32_t team_size = 2;
  bool operator==(const CapacityPlan&) const = default;
};

// The plan for the object of a placement from place(). It reuses the candidates of the placement.
// Each robot carries up to `capacity` > 0, in the unit of the weight. The plan depends on the
// polygon, the holes, the centre of mass, and all settings that affect loads except the number of
// teams or robots.
//
// Area, circle, distance and random choose teams one after another. So the first k teams of a
// selection are a placement of k teams, and a plan costs as much as selecting the needed teams.
// Teams at equal angles differ for each number of teams; only their loads are computed, up to the
// first overloaded robot. Swapped teams also differ for each number, and each number costs its own
// swaps. The least number of balanced robots follows from the weight, the capacity and the failures
// to survive; whether such a set exists is not checked. For given supports no plan is possible.
CapacityPlan plan_capacity(const Placement& placement, double capacity);

// The number of robots needed if any one robot may fail. While all work, no planned load exceeds
// the capacity. After a failure, the others carry the object, and no load by springs
// (load_models.h) exceeds the capacity. Sudden changes of load are not considered.
struct FailurePlan {
  bool possible = false;
  std::uint32_t robots = 0;  // if possible, the least number found
  double greatest_load = 0;  // of a robot, intact or after any one failure, if possible
  std::uint32_t tried = 0;   // the most robots tried
  bool operator==(const FailurePlan&) const = default;
};

// Finds the least number of robots for the placement's method, at the places where place() would
// put them. The search begins with the least number that the weight and, for balanced robots,
// `survive` permit. It ends when there is no place for more teams, when check_swaps() (swaps.h)
// refuses more, at most_teams_tried() teams (for balanced robots, at most_robots), or before it
// would compute more than most_loads_planned loads in all; m robots need m^2. For balanced robots
// it tries at most most_sets_planned numbers, each with a whole search. For given supports no plan
// is possible.
inline constexpr std::uint64_t most_loads_planned = std::uint64_t{1} << 21;
inline constexpr std::uint32_t most_sets_planned = 8;
FailurePlan plan_for_failures(const Placement& placement, double capacity);

// Whether two placements agree in everything on which plans depend. O(n).
bool same_plan(const Placement& a, const Placement& b);

}  // namespace evenlift
