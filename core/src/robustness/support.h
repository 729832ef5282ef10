// Where C is on the lifting base, for all load models.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The robots that can carry load, from C in units of L: nothing overflows, and the tolerance is tau
// itself.
struct Support {
  double unit = 0;                    // L, or more far from the origin (known_size.h)
  bool on_a_line = false;             // the robots and C are on one line, within tolerance
  std::vector<std::uint32_t> robots;  // their numbers
  Points at;    // positions from C; on a line (t, 0), with t along it, exactly 0 for a robot within
                // tolerance of C
  Points hull;  // corners of H from C, counter-clockwise; none on a line
};

// nullopt if C is outside H by more than the tolerance. All robots if C is inside by more, or all
// are on one line; else those on the edge of H nearest to C. O(m log m).
std::optional<Support> find_support(const Points& robots, const Vec2& centre, double diameter);

// The given loads for the robots of the support, 0 for all others of m. O(m).
std::vector<double> spread_out(const Support& support, const std::vector<double>& loads,
                               std::size_t m);

}  // namespace evenlift
