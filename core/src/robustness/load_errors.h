// How loads change if robots are off their places (algorithm.md, Accuracy).
#pragma once

#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

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
  std::vector<double> planned_at(const Points& places) const;

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
