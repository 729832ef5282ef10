// Small polygons with settings, one for each number, for comparing the core with the oracle: every
// family, with an emphasis on hard cases (ties, collinear points, thin, far away). They are the
// same on every platform: own generator, own sine.
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

/// The families, in the order in which `make_case` cycles through them.
inline constexpr const char* families[] = {"regular", "convex", "star",      "comb",     "spiral",
                                           "random",  "grid",   "staircase", "symmetric"};

/// One attempt at the case of that number, of family number % 9. Most are valid.
Case attempt_case(std::uint64_t number, std::uint64_t attempt);

/// The first attempt that the oracle accepts.
Case make_case(std::uint64_t number);

/// One attempt at a case of the same families with all difficulty in the shape: symmetric, with
/// straight vertices, parallel edges and centres of mass in awkward places, but never within a few
/// tolerances of another shape.
Case attempt_plain_case(std::uint64_t number, std::uint64_t attempt);

/// The first attempt that the oracle accepts.
Case make_plain_case(std::uint64_t number);

/// Points joined in any order, on a grid so small that they often touch: rarely valid.
Case make_careless_case(std::uint64_t number);

/// Cases made by hand, each for one difficulty; all valid.
std::vector<Case> hand_made();

}  // namespace small_polygons
