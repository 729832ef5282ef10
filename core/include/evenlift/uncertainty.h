// Bounds on loads and stability if conditions are known only roughly. The weight may act anywhere
// within some distance of C if C is uncertain (in offshore lifting, the "centre of gravity
// envelope"), if the ground slopes, or if the object is braked (tilt.h). Also, the ground may be
// uneven, or the height of a robot may be wrong.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/load_models.h"
#include "evenlift/vec.h"

namespace evenlift {

// The distance by which C can be off before the object tips, if robots push back and none is
// overloaded: the least distance of C from the line of an edge of H, in units of length. It is 0 if
// this distance is at most the tolerance tau L, if H has no area (as with a single team of two), or
// if C is outside H. `hull` must come from convex_hull, and `diameter` is L. O(h) for h corners.
double tipping_distance(const Points& hull, const Vec2& centre, double diameter);

// How far the weight and the robots' heights may differ from what the placement assumes.
struct Disturbance {
  double reach = 0;   // the weight acts anywhere within this distance of C, in units of length
  double uneven = 0;  // heights are off by up to this many times the length by which a robot gives
                      // way under the mean load
  double kept = 1;    // at least this part of the weight acts on the robots, 0 < kept <= 1: on a
                      // slope, the cosine of its angle
  // Whether anything may differ; then the loads are ranges. O(1).
  bool any() const { return reach > 0 || uneven > 0 || kept < 1; }
  bool operator==(const Disturbance&) const = default;
};

// Whether H contains all points within `reach` of C: reach <= tipping_distance, within tolerance
// (tau L). O(1).
bool is_within_base(double reach, double tipping_distance, double diameter);

struct LoadRange {
  double least = 0, greatest = 0;
};

// Whether a disturbance turns the loads of this model into ranges. O(1).
constexpr bool has_ranges(LoadModel model) {
  return model == LoadModel::plan || model == LoadModel::springs;
}

// The changes that a disturbance may make to the loads of robots that give way like springs.
struct LoadChanges {
  double kept = 1;                // as in the disturbance
  bool others_may_carry = false;  // whether robots without load may begin to carry
  // The greatest possible change of each load, as long as the same robots carry load.
  std::vector<double> by;
  // The greatest load of each robot, whichever robots go slack: that of worst_loads()
  // (load_models.h) with C anywhere within the reach.
  std::vector<double> at_worst;
};

// The changes that a disturbance may make. `springs` must be the loads of the same robots. Errors
// of the heights change the load of robot i by at most W/m * uneven * sum over j of |P_ij|. Here P
// = I - A (A'A)^-1 A', and A has a row [1, x_j, y_j] for each robot j that carries load. P
// subtracts from the errors the plane that fits them best. P is 0 if only three robots, not on one
// line, carry load. O(m log m + m h) for h corners of H, and O(m^2) more if heights are off.
LoadChanges load_changes(const Points& robots, const Vec2& centre, double diameter, double weight,
                         const SpringLoads& springs, const Disturbance& disturbance);

// Whether the set of robots that carry load may change. It may if robots without load may begin to
// carry, or if a robot may go slack because its load may fall below 0 by more than the tolerance
// (tau times the sum of the loads). O(m).
bool may_let_go(const std::vector<double>& loads, const LoadChanges& changes);

// The ranges of the loads of robots that give way like springs. Without the disturbance, the robots
// must be in equilibrium with `loads`. A range extends from `kept` * load - `by`, or from 0 if this
// is negative, to load + `by`. If may_let_go() is true, every greatest load is that of `at_worst`
// instead. The least loads presume that the same robots keep carrying. O(m).
std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const LoadChanges& changes);

// The greatest radius around the assumed place of C within which the bounds on loads by springs
// exceed no robot's capacity. A robot without a capacity has no limit. The bounds are valid only
// while the same robots carry load, so the radius is at most springs.same_within minus `reach`. It
// is also at most the tipping distance minus `reach`, but never below 0. Causes other than the
// error of C change the loads by `besides`, and move the weight by up to `reach` from C. If they
// may change which robots carry load (may_let_go()), the radius is 0, and `besides.at_worst` bounds
// the loads. Returns nothing if a robot may be overloaded by more than tau times its capacity even
// with C at its assumed place. O(m).
std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities,
                                             const LoadChanges& besides = {}, double reach = 0);

}  // namespace evenlift
