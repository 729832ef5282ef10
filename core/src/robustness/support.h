// The position of C on the lifting base, which all load models use.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The robots that can carry load, relative to C in units of L. So nothing overflows, however large
// or small the object is, and the tolerance is tau itself.
struct Support {
  double unit = 0;                    // L, or more far from the origin: see known_size.h
  bool on_a_line = false;             // all of these robots and C are on one line, within tolerance
  std::vector<std::uint32_t> robots;  // their numbers
  Points at;    // their positions from C; on a line (t, 0), with t along the line, and exactly 0 if
                // the robot is within tolerance of C
  Points hull;  // the corners of H from C, counter-clockwise; none on a line
};

// Returns nullopt if C is outside the lifting base H by more than the tolerance. Otherwise returns
// all robots if C is inside by more than the tolerance or all robots are on one line, else the
// robots on the edge of H nearest to C. O(m log m).
std::optional<Support> find_support(const Points& robots, const Vec2& centre, double diameter);

// A list of m loads: the given ones for the robots of the support, and 0 for all others. O(m).
std::vector<double> spread_out(const Support& support, const std::vector<double>& loads,
                               std::size_t m);

}  // namespace evenlift
