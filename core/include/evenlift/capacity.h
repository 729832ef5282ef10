// How many robots an object needs when each can carry only so much (thesis 1, 5.3).
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift {

// More teams than this are not tried.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

// The robots that carry more than `capacity`, by number: robot 2 t + e is at end e (0: r1, 1: r2)
// of team t. O(teams).
std::vector<std::size_t> overloaded_robots(const Placement& placement, double capacity);

struct CapacityPlan {
  // Whether some number of teams keeps every robot within the capacity; then the least such number
  // with the placement's method, and the load that is greatest among its robots.
  bool possible = false;
  std::uint32_t teams = 0;
  double greatest_load = 0;
  // Otherwise: the most teams that were tried. Fewer than most_teams_for_capacity says that the
  // method found no place for more.
  std::uint32_t tried = 0;
  bool operator==(const CapacityPlan&) const = default;
};

// Plans the object of a placement that place() gave for robots that carry up to `capacity` each, in
// the unit of its weight: a number above 0. It depends on the placement's polygon, centre of mass,
// method, minimum load ratio, weight and seed, not on its number of teams.
// The candidates are not looked for anew. area, circle, distance and random choose teams one after
// another, so that the first k teams of one selection are the teams of k: its cost is that of
// selecting the teams that are needed, or 512. distributed has other teams for each number; of
// these only the loads are worked out, and each number is given up at the first robot that carries
// too much.
CapacityPlan plan_capacity(const Placement& placement, double capacity);

// Whether the plans of two placements for one capacity are the same, as nothing that they depend on
// differs. O(n).
bool same_plan(const Placement& a, const Placement& b);

}  // namespace evenlift
