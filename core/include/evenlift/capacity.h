// The number of robots that an object needs if each can carry only so much (thesis 1, 5.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift {

// The greatest number of teams that is tried, unless they are exchanged until they hold.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

// The greatest number of teams that a plan tries with these settings: most_exchanged_teams
// (exchange.h) if they are exchanged until they hold, and else most_teams_for_capacity. O(1).
std::uint32_t most_teams_tried(const Settings& settings);

// The numbers of the robots that carry more than `capacity`, as find_robot() (loads.h) counts them.
// O(robots).
std::vector<std::size_t> overloaded_robots(const Placement& placement, double capacity);

// The same of any loads, in the order of the robots. O(robots).
std::vector<std::size_t> overloaded_robots(const std::vector<double>& loads, double capacity);

struct CapacityPlan {
  bool possible = false;     // whether some number of teams keeps every robot within the capacity
  std::uint32_t teams = 0;   // if possible, the least such number with the placement's method
  double greatest_load = 0;  // if possible, the greatest load of a robot with so many teams
  std::uint32_t tried = 0;   // the most teams that were tried; if not possible and below
                             // most_teams_tried(), the method found no place for more
  // Robots in a team. Balanced robots are one team: of the least number of robots if that is
  // possible, and otherwise of most_robots.
  std::uint32_t team_size = 2;
  bool operator==(const CapacityPlan&) const = default;
};

// Plans for the object of a placement, which must come from place(), and for robots that carry up
// to `capacity` > 0 each, in the unit of its weight. The plan depends on the placement's polygon
// and centre of mass, and on its settings, except for the number of teams or robots and what only
// describes the result (overlays, units and the like); same_plan() compares exactly these. The
// candidates of the placement are reused.
//
// The methods area, circle, distance and random choose teams one after another, so the first k
// teams of a selection are a placement of k teams; a plan costs as much as selecting the teams that
// are needed, at most most_teams_tried(). Distributed teams are others for each number, of which
// only the loads are computed, and a number of teams is rejected as soon as one robot carries too
// much. Teams that are exchanged until they hold are others for each number, too: each costs as
// much as its exchanges (exchange.h). Balanced robots bear the same as planned, so their least
// number follows from the weight, and from the failures that they are to survive; that such a set
// exists is not tried.
CapacityPlan plan_capacity(const Placement& placement, double capacity);

// How many robots it takes if any one may fail: with all of them at work none bears more than the
// capacity, and when one fails, whichever it is, the others carry the object and none of them bears
// more than that, if all are equally stiff (load_models.h, springs).
struct FailurePlan {
  bool possible = false;
  std::uint32_t robots = 0;  // if possible, the least number that was found to be enough
  double greatest_load = 0;  // if possible, what one robot bears at most, whichever fails
  std::uint32_t tried = 0;   // the most robots that were tried
  bool operator==(const FailurePlan&) const = default;
};

// The least number of robots for that with the placement's method, each number being placed as
// place() would place it. It begins with the number that the weight alone asks for, and ends where
// the method finds no place for more, at most_teams_tried(), or when the loads of
// most_loads_planned robots were computed. Of balanced robots most_sets_planned numbers are tried,
// each of which takes a whole search (balanced.h).
inline constexpr std::uint64_t most_loads_planned = std::uint64_t{1} << 21;
inline constexpr std::uint32_t most_sets_planned = 8;
FailurePlan plan_for_failures(const Placement& placement, double capacity);

// Whether two placements have the same plan for every capacity, because they agree in everything on
// which it depends. O(n).
bool same_plan(const Placement& a, const Placement& b);

}  // namespace evenlift
