// The size on which the tolerance for robots far from the origin is based.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// Returns L, or more if rounding of large coordinates moves a robot by more than tau L, as for an
// object of size 10 at coordinates of 1e9. In that case the two robots of a team and C are
// collinear only up to this rounding, and tau times the returned size allows for it. O(m).
inline double known_size(const Points& robots, const Vec2& centre, double diameter) {
  double reach = max_norm(centre);
  for (const Vec2& robot : robots) reach = std::max(reach, max_norm(robot));
  return std::max(diameter, 0x1p-51 * reach / tau);
}

// --- Coordinates in which points have their centroid at the origin and the same mean square along
// every direction. Linear changes of coordinates do not change the loads of springs, but in
// these coordinates a long, thin set is as well conditioned as a round one.

struct StandardFrame {
  Vec2 mean;
  // The coordinates of a point p are axis[k] . (p - mean); each has the mean square 1. The second
  // axis is 0 if the points are on one line within tau, and both are 0 if the points are at one
  // place within tau.
  Vec2 axis[2] = {};

  Vec2 operator()(const Vec2& p) const { return {dot(axis[0], p - mean), dot(axis[1], p - mean)}; }
};

// Returns the frame of one or more points, whose coordinates are in units of L. Its first axis has
// the direction from the centroid to the farthest point. O(m).
StandardFrame standard_frame(const Points& points);

// --- Finds the robots that can carry load, given the position of C on the lifting base H. All load
// models use them.

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

// --- Finds the least possible greatest load of a robot, for a weight of 1 and C at the origin.

// Uses the formula at best_load() (load_models.h), over all ordered pairs of robots. There must be
// at least one robot, and C must be inside the lifting base. O(m^3).
double best_share_by_pairs(const Points& robots);

// Uses cutting planes. Let S(b) be the sum of max(0, 1 + b . q) over the robots q. It is convex in
// b, and the share is 1 / (the least S(b)). `hull` is the lifting base, counter-clockwise, with C
// inside. O(m) for each of about a hundred steps.
double best_share_by_cuts(const Points& robots, const Points& hull);

// Finds the share for robots at points (t, 0), on one line with C. O(m log m).
double best_share_on_line(const Points& robots);

}  // namespace evenlift
