// How many robots an object needs when each can carry only so much (thesis 1, 5.3).
#pragma once

#include <cstdint>

#include "evenlift/document.h"
#include "evenlift/result.h"

namespace evenlift {

// More teams than this are not tried.
inline constexpr std::uint32_t most_teams_for_capacity = 512;

struct CapacityPlan {
  // Whether some number of teams keeps every robot within the capacity; then the least such number
  // with the document's method, and the load that is greatest among its robots.
  bool possible = false;
  std::uint32_t teams = 0;
  double greatest_load = 0;
  // Otherwise: the most teams that were tried. Fewer than most_teams_for_capacity says that the
  // method found no place for more.
  std::uint32_t tried = 0;
};

// Plans the document's object for robots that carry up to `capacity` each, > 0, in the unit of its
// weight. The number of teams in its settings does not matter. The document's errors as place().
// area, circle and distance choose teams one after another, so one placement tells of every smaller
// number: the cost of place() with at most 512 teams. distributed and random are placed anew for
// each number from weight / (2 capacity) on.
Result<CapacityPlan> plan_capacity(const Document& document, double capacity);

}  // namespace evenlift
