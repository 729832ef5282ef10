// Bounds on loads and stability if conditions are known only roughly: C is uncertain (in offshore
// lifting, the "centre of gravity envelope"), the ground slopes, the object is braked (tilt.h), the
// ground is uneven, or the height of a robot is wrong.
//
// The ranges presume that the robots are set to their planned loads with C as assumed, that each
// then keeps its height, and that all yield like equally stiff springs under a rigid object.
#pragma once

#include <cstddef>
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

// How far conditions may differ from what the placement assumes. Lengths are in the unit of the
// coordinates. disturbance_of() (tilt.h) makes it of the settings.
struct Disturbance {
  double com_radius = 0;       // E: C is off by up to this
  double height = 0;           // h: the height of C above the plane of the lifting points
  double slope = 0;            // the greatest slope of that plane, as a ratio
  double acceleration = 0;     // the greatest acceleration along the ground, in g
  double uneven = 0;           // heights are off by up to this
  std::optional<double> give;  // the length > 0 by which a robot gives way under the mean load

  // Whether anything but C itself may differ, and whether anything may; then the loads are ranges.
  // The height of C alone changes nothing. O(1).
  bool besides_com() const { return slope > 0 || uneven > 0 || (height > 0 && acceleration > 0); }
  bool any() const { return com_radius > 0 || besides_com(); }
  bool operator==(const Disturbance&) const = default;
};

// What a disturbance amounts to for certain robots. With h > 0, uneven heights tilt the object by
// up to k_u = uneven * max over unit vectors v of the sum over i of |v . S^-1 (p_i - p)|, where p is
// the centroid of the robots' places p_i, and S the sum of (p_i - p) (p_i - p)^T. Then k1 is the
// slope plus k_u, and k2 is the acceleration. The bound k_u presumes that all robots carry.
struct DisturbanceEffect {
  double tilt = 0;  // k_u, as a ratio; 0 if h is 0
  // The resultant of weight and inertia meets the plane of the lifting points within this distance
  // of C, and may meet it anywhere there: E + h (k1 + k2 sqrt(1 + k1^2)).
  double reach = 0;
  double reach_of_loads = 0;  // E + h (k1 + k2); `kept` * reach is never more
  double uneven = 0;  // heights are off by this many times the give; infinite without a give
  double kept = 1;    // 1 / sqrt(1 + k1^2), the part of the weight that acts across the plane
};

// The effect of a disturbance on these robots. `diameter` is L. O(m log m) if heights are off,
// otherwise O(m).
DisturbanceEffect effect_on(const Points& robots, const Vec2& centre, double diameter,
                            const Disturbance& disturbance);

// The disturbance after one of these robots has failed. The others are as stiff as before, but
// their mean load, and so the give under it, is greater. O(1).
Disturbance after_failure(Disturbance disturbance, std::size_t robots);

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
  DisturbanceEffect effect;
  bool others_may_carry = false;  // whether robots without load may begin to carry
  // The greatest possible change of each load, as long as the same robots carry load.
  std::vector<double> by;
  // The greatest load of each robot, whichever robots go slack: that of worst_loads()
  // (load_models.h) with C anywhere within the reach of loads.
  std::vector<double> at_worst;
  // The least load of each robot, whichever robots go slack: `kept` times that of least_loads()
  // with C anywhere within the reach.
  std::vector<double> at_least;
};

// The changes that a disturbance may make. `springs` must be the loads of the same robots. Errors
// of the heights change the load of robot i by at most W/m * uneven * sum over j of |P_ij|. Here P
// = I - A (A'A)^-1 A', and A has a row [1, x_j, y_j] for each robot j that carries load. P
// subtracts from the errors the plane that fits them best. P is 0 if only three robots, not on one
// line, carry load. Without a give, the change has no bound where the sum is not 0. O(m log m + m h)
// for h corners of H, seldom more for the least loads, and O(m^2) more if heights are off.
LoadChanges load_changes(const Points& robots, const Vec2& centre, double diameter, double weight,
                         const SpringLoads& springs, const Disturbance& disturbance);

// The greatest loads of load_ranges(). `loads` are in equilibrium; `springs` are the loads by springs
// of the same robots. Costs as much as load_changes(), without the least loads.
std::vector<double> greatest_loads(const Points& robots, const Vec2& centre, double diameter,
                                   double weight, const std::vector<double>& loads,
                                   const SpringLoads& springs, const Disturbance& disturbance);

// Whether the set of robots that carry load may change. It may if robots without load may begin to
// carry, or if a robot may go slack: `kept` * load - `by` is below 0 by more than the tolerance (tau
// times the sum of the loads). O(m).
bool may_let_go(const std::vector<double>& loads, const LoadChanges& changes);

// The ranges of the loads of robots that give way like springs. Without the disturbance, the robots
// must be in equilibrium with `loads`. A range extends from `kept` * load - `by`, or from 0 if this
// is negative, to load + `by`. If may_let_go() is true, every range extends from `at_least` to
// `at_worst` instead. O(m).
std::vector<LoadRange> load_ranges(const std::vector<double>& loads, const LoadChanges& changes);

// The greatest radius around the assumed place of C within which the bounds on loads by springs
// exceed no robot's capacity. A robot without a capacity has no limit. The bounds are valid only
// while the same robots carry load, so the radius is at most springs.same_within minus the reach.
// It is also at most the tipping distance minus the reach, but never below 0. Causes other than the
// error of C change the loads by `besides`, whose reach it is. If they may change which robots carry
// load (may_let_go()), the radius is 0, and `besides.at_worst` bounds the loads. Returns nothing if
// a robot may be overloaded by more than tau times its capacity even with C at its assumed place.
// O(m).
std::optional<double> radius_within_capacity(const SpringLoads& springs, double tipping_distance,
                                             const std::vector<std::optional<double>>& capacities,
                                             const LoadChanges& besides = {});

}  // namespace evenlift
