// Describes the robots of a placement one by one: where they stand, which way they face, their
// loads by each model, and the failures that they withstand. place() does not compute these values.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/equilibrium.h"
#include "evenlift/failures.h"
#include "evenlift/load_models.h"
#include "evenlift/placement.h"
#include "evenlift/supports.h"
#include "evenlift/tilt.h"
#include "evenlift/uncertainty.h"

namespace evenlift {

struct PlacedRobot {
  Vec2 at;                   // the lifting point
  Vec2 contact;              // where it touches the boundary
  Vec2 stand;                // the centre of its body
  bool beneath = false;      // whether it is beneath the object and has no contact (supports.h);
                             // if so, `contact` and `stand` are the lifting point
  std::uint32_t number = 1;  // by which people know it (Placement::number_of())
  std::string name;          // of a given robot, if it has one
  std::uint32_t team = 0;
  double load = 0;  // as planned
  // The direction of the inward normal at the contact, in degrees in (-180, 180]. At a vertex it is
  // halfway between the normals of the two edges, and beneath the object it is 0.
  double heading_deg = 0;
  Vec2 direction = Vec2(1, 0);  // the heading as a unit vector, up to rounding
};

// Returns the robots, team after team. A robot without a body counts as standing at a vertex if it
// is within tolerance (tau L) of an end of its edge. O(n + m).
std::vector<PlacedRobot> placed_robots(const Placement& placement);

// Returns whether the object stands and, if not, over which robots it tips (equilibrium.h).
// O(m log m).
Equilibrium equilibrium(const Placement& placement);

// Returns whether equilibrium alone determines the loads. This is so if there are at most three
// robots, each at a different corner of H. O(teams).
bool loads_are_determined(const Placement& placement);

// Returns the given supports that do not fit or are too near to each other (supports.h), or none if
// the method is not `given`. O(m log n + m^2).
std::vector<Misfit> misfits(const Placement& placement);

// The loads by the models of load_models.h, in the order of the robots, and the changes that a
// disturbance may make. model_loads() returns nothing if there are no teams, or if the object
// falls. It takes O(m log m), or O(m^3) for up to 64 robots; with a disturbance also O(m h), or
// O(m^2) if heights are off.
struct ModelLoads {
  SpringLoads springs;
  double best = 0;
  std::vector<double> worst;
  Disturbance disturbance = {};
  LoadChanges changes = {};  // empty without a disturbance
  // Added by with_inaccuracy(): by how much the loads as planned, and by springs, may change if all
  // robots are off by the setting `accuracy`. Otherwise empty.
  std::vector<double> planned_doubt = {}, springs_doubt = {};

  // Whether loads that have ranges (has_ranges()) are ranges. O(1).
  bool are_ranges() const { return disturbance.any() || !planned_doubt.empty(); }
};
std::optional<ModelLoads> model_loads(const Placement& placement,
                                      const Disturbance& disturbance = {});

// The same loads, with what may change if all robots are off by the setting `accuracy`, to first
// order (accuracy.h). If robots may then let go, the ends are those with C as much farther off. O(m^2),
// and as much as model_loads().
ModelLoads with_inaccuracy(ModelLoads models, const Placement& placement);

// Returns the load of each robot by a model, for display. The load is a range if there is a
// disturbance or an inaccuracy, and the model has ranges (uncertainty.h); otherwise it is one value.
// For the model `best`, the value of every robot is the least possible greatest load. Without
// `models` the loads are as planned. O(m).
std::vector<LoadRange> loads_by(LoadModel model, const Placement& placement,
                                const std::optional<ModelLoads>& models);

// Returns whether that may change which robots carry load (uncertainty.h); false if the
// model has no ranges. O(m).
bool may_let_go(LoadModel model, const Placement& placement,
                const std::optional<ModelLoads>& models);

// Returns the load of each robot by a model, for display: that of loads_by(), but without the given
// conditions if the object `tips` under them, since what tips carries nothing. O(m).
std::vector<LoadRange> shown_loads(const Placement& placement, LoadModel model,
                                   const std::optional<ModelLoads>& models, bool tips);

// The failures and the error of C that the object survives without tipping, if robots push back and
// none is overloaded. failures.h defines the numbers of failures, which are -1 without robots;
// uncertainty.h defines the tipping distance. O(m log m).
struct Robustness {
  int failures_carried = -1, failures_steady = -1;
  double tipping_distance = 0;
  // The number of robots that may fail, whichever they are, while C stays at least `clear`
  // (document.h) inside the remaining lifting base. It is at most failures_steady.
  int failures_clear = -1;
};
Robustness robustness(const Placement& placement);

// Returns the effect of the given conditions (disturbance_of() of tilt.h) on the placed robots
// (uncertainty.h). O(m log m).
DisturbanceEffect effect_on(const ShownPlacement& of);

// Returns the least press downward at q, a vertical force at the height of the lifting points, that
// tips the object under the given conditions: the least of weight * (d_e - reach) / (distance of q
// from e) over the edges e of H beyond which q lies, where d_e is the distance of C from e. On level
// ground with an exact C it is tipping_force() (stability.h). It is infinite if q is in H, and 0 if
// the object tips without it, or if H has no area and the reach is not 0. O(m log m).
double tipping_force(const ShownPlacement& of, const Vec2& q);

// Returns the greatest load of each robot that statics allows under conditions with this effect:
// worst_loads() (load_models.h) with C anywhere within the reach. It returns nothing if the object
// falls. O(m log m + m h).
std::optional<std::vector<double>> worst_loads(const Placement& placement,
                                               const DisturbanceEffect& effect);

// The circles about C that a picture shows, each for one slope, among them the one that is set. Under the assumptions of tilt.h,
// the object can tip on ground of that slope if the circle's point downhill from C lies outside the
// lifting base. The circles are sorted from small to large. Circles around the whole lifting base
// are left out, and so are circles too close to C or to others to be told apart at `scale` pixels
// per unit of length. A circle whose label would cover C has no label. There are no circles if the
// height of C is 0, H has no area, or the object falls. O(h).
struct TiltCircle {
  double degrees = 0, radius = 0;  // the radius, in units of length, includes the C uncertainty
  bool is_labelled = true;
  bool is_set = false;  // the slope of Carrying
};
std::vector<TiltCircle> tilt_circles(const ShownPlacement& of, double scale);

// single_failures() returns the effect of each robot's failure, in the order of the robots.
// single_failure() returns the effect of one robot's failure; robots are numbered as in
// find_robot() (loads.h). An effect is empty if the other robots do not carry the object.
// failures.h states the cost.
std::vector<std::optional<RestOfRobots>> single_failures(const Placement& placement,
                                                         const Disturbance& disturbance = {});

std::optional<RestOfRobots> single_failure(const Placement& placement, std::size_t robot,
                                           const Disturbance& disturbance = {});

// Returns the loads by springs after this robot has failed, as ranges if there is a disturbance.
// The load of the failed robot is 0. The result is empty if the others do not carry the object.
// O(m log m); with a disturbance, also the cost of load_changes() (uncertainty.h).
std::optional<std::vector<LoadRange>> ranges_without(const Placement& placement, std::size_t robot,
                                                     const Disturbance& disturbance);

// Returns the ranges in which a team can stand on edges a and b, which are the edges of the chord's
// ends r1 and r2. Robots that may stand anywhere have the range of the two edges, if there is one.
// Other robots have the parts of this range that they can use (candidates.h). O(1), or
// O(usable intervals of a times those of b).
std::vector<PairRange> ranges_of(const Placement& placement, const Chord& chord);

// Returns the placement with its teams on other candidates, such as the best choice of optimum.h.
// O(n log n).
Placement with_choice(Placement placement, std::vector<std::uint32_t> candidates);

// Returns the placement after this robot has failed, for pictures and words. The robot stays in its
// team, with a load of 0. H, the coverage, the hold and the loads are those of the others, which
// share the weight by springs; `closure` numbers the robots without the failed one. If the others
// do not carry the object, all loads and the coverage are 0, and `loads` is empty. O(n log n).
Placement with_failure(Placement placement, std::size_t robot);

}  // namespace evenlift
