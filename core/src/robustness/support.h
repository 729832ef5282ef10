// Frames of robots, those that can carry, the best load, and errors of loads.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/tolerance.h"
#include "evenlift/vec.h"

namespace evenlift {

// --- The size on which the tolerance for robots far from the origin is based.

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

// --- How loads change if robots are off their places (algorithm.md, Accuracy).

// Where a robot may be off: along either of two unit vectors, in any direction, or nowhere. Along an
// edge the two are opposite; at a vertex each is along one of its edges.
struct ErrorDirection {
  enum class Kind { along, any, none } kind = Kind::none;
  Vec2 ways[2] = {};
};

// The derivatives of loads by the places of robots, in units of weight per length. Let p be the
// centroid of the robots that carry load, S and P as in uncertainty.h, and W the weight. If the
// robots are equally stiff, the place s_j of robot j along t_j changes the load of robot i by
// P_ij W (S^-1 (C - p)) . t_j - f_j (p_i - p) . S^-1 t_j. Forces that are controlled as planned miss
// the balance after an error, and springs make up for it: only the second term remains, with the
// planned f_j.
class LoadErrors {
 public:
  // `loads` are in equilibrium; without `are_planned` they are those by springs. `unit` is a length
  // of the size of the object. O(m).
  LoadErrors(const Points& robots, const Vec2& centre, double unit, double weight,
             std::vector<double> loads, bool are_planned, std::vector<ErrorDirection> directions);

  // The sum over j of the greatest derivatives of a load, 0 if robot i carries none. O(m); more than
  // 1,000 robots get an upper bound in O(1).
  double sum(std::size_t i) const;

  // The unit vectors along which errors of the robots raise the load of robot i, to first order; 0
  // where an error changes nothing. O(m).
  Points worst_errors(std::size_t i) const;
  // The other way of robot j: one that is not this one of its unit vectors. O(1).
  Vec2 other_way(std::size_t j, const Vec2& way) const;

  // The planned loads at other places, with what springs add to keep the balance. O(m).
  std::vector<double> planned_at(const Points& robots) const;

 private:
  Vec2 derivative(std::size_t i, std::size_t j) const;  // by the place of robot j in the plane
  Vec2 worst_way(std::size_t i, std::size_t j) const;

  Points robots_;
  Vec2 centre_;
  double unit_, weight_;
  std::vector<double> loads_;
  bool are_planned_;
  std::vector<ErrorDirection> directions_;
  Points places_;  // of all robots in the standard frame of those that carry load
  Vec2 axis_[2] = {}, of_centre_ = {};
  double carrying_ = 0, total_ = 0;  // the number of robots that carry load, and the sum of loads
};

}  // namespace evenlift
