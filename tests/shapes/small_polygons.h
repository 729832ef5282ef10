// Small polygons with settings, one per number, for comparing the core with the oracle: every
// family, mostly hard (ties, collinear points, thin, far away). Own generator and sine make them
// the same on every platform.
#pragma once

#include "oracle/oracle.h"

#include <cstdint>
#include <string>
#include <vector>

namespace small_polygons {

struct Case {
  std::string name;  // family and applied changes, for messages
  oracle::Problem problem;
};

/// As `make_case` cycles through them.
inline constexpr const char* families[] = {"regular", "convex", "star",      "comb",     "spiral",
                                           "random",  "grid",   "staircase", "symmetric"};

/// Of family number % 9. Most are valid.
Case attempt_case(std::uint64_t number, std::uint64_t attempt);

/// The first that the oracle accepts.
Case make_case(std::uint64_t number);

/// All difficulty is in the shape: symmetric, with straight vertices, parallel edges and centres in
/// awkward places, but never within a few tolerances of another shape.
Case attempt_plain_case(std::uint64_t number, std::uint64_t attempt);

Case make_plain_case(std::uint64_t number);

/// In any order, on a grid so small that they often touch: rarely valid.
Case make_careless_case(std::uint64_t number);

/// Each has one difficulty; all are valid.
std::vector<Case> hand_made();

}  // namespace small_polygons
