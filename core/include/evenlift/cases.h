// The loads in each case, one condition at a time and all at once: the table to sign before a lift.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift {

// A case of loading: level and still with C as given, one of the given conditions alone, all of them,
// or all of them after one robot has failed.
struct LoadCase {
  enum class Kind : std::uint8_t { level, com, slope, acceleration, uneven, all, failure };
  Kind kind = Kind::level;
  std::optional<std::size_t> failed;  // for failure: the robot, from 0
  // The greatest load, as planned, and whose it is, and the least load; after a failure they are loads
  // by springs. Empty if the object falls or can tip. After a failure under conditions, the least load
  // is not computed.
  std::optional<double> greatest, least;
  std::optional<std::size_t> robot;
  // The greatest use of a robot (Report::use); empty without capacities, or without loads.
  std::optional<double> use;
  bool stays = false;  // whether the object stands and cannot tip
};

// A case's name in JSON, such as "level" or "all". O(1).
std::string_view name(LoadCase::Kind kind);

// All cases: `level`, each condition that is given, `all` if there are several, and the failure of
// each robot. Without robots there are none. Costs a report (report.h) for each case, and
// single_failures() (failures.h).
std::vector<LoadCase> load_cases(const ShownPlacement& of);

// The index of the worst case: the first that does not stay, or else that with the greatest use or,
// without capacities, the greatest load. O(cases).
std::optional<std::size_t> worst_case(const std::vector<LoadCase>& cases);

}  // namespace evenlift
