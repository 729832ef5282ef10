// How loads change if robots are off their places (algorithm.md, Accuracy).
#pragma once

#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// Where a robot may be off: along a unit vector, in any direction, or nowhere.
struct ErrorDirection {
  enum class Kind { along, any, none } kind = Kind::none;
  Vec2 along = {};
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

  // The sum over j of the absolute derivatives of a load, 0 if robot i carries none. O(m); more than
  // 1,000 robots get an upper bound in O(1).
  double sum(std::size_t i) const;

  // The places if all robots are off by `error`, each in the sense that raises the load of robot i,
  // to first order. O(m).
  Points worst_places(std::size_t i, double error) const;

  // The planned loads at other places, with what springs add to keep the balance. O(m).
  std::vector<double> planned_at(const Points& places) const;

 private:
  Vec2 derivative(std::size_t i, std::size_t j) const;  // by the place of robot j in the plane

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
