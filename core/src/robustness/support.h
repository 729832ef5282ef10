// Finds the robots that can carry load, given the position of C on the lifting base H. All load
// models use them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// The robots that can carry load. Positions are relative to C in multiples of `unit`, so that
// nothing overflows and the tolerance is tau itself.
struct Support {
  double unit = 0;         // L, or more if the object is far from the origin (known_size.h)
  bool on_a_line = false;  // the robots and C are on one line, within tolerance
  std::vector<std::uint32_t> robots;  // their numbers
  // The robots' positions. On a line, they are (t, 0) with the position t along the line, which is
  // exactly 0 for a robot within tolerance of C.
  Points at;
  Points hull;  // corners of H, counter-clockwise; empty on a line
};

// Returns nullopt if C is outside H by more than the tolerance, or there are no robots. The support
// consists of all robots if C is inside H by more than the tolerance, or if all robots are on one
// line. Otherwise it consists of the robots on the line of the edge of H nearest to C. O(m log m).
std::optional<Support> find_support(const Points& robots, const Vec2& centre, double diameter);

// The loads of all m robots: the given ones for the robots of the support, 0 for the others. O(m).
std::vector<double> spread_out(const Support& support, const std::vector<double>& loads,
                               std::size_t m);

}  // namespace evenlift
