// Describes the robots of a placement one by one: where they stand and face, their loads by each
// model, and the failures that they withstand. place() does not compute this.
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
  Vec2 at = Vec2::Zero();       // the lifting point
  Vec2 contact = Vec2::Zero();  // where it touches the boundary
  Vec2 stand = Vec2::Zero();    // the centre of its body
  bool beneath = false;         // whether it is beneath the object, touching nothing (supports.h);
                                // if so, contact and stand are the lifting point
  std::uint32_t team = 0;
  double load = 0;  // as planned
  // The direction of the inward normal at the contact, in degrees in (-180, 180]; at a vertex,
  // halfway between the normals of its two edges; 0 beneath the object.
  double heading_deg = 0;
  Vec2 direction = Vec2(1, 0);  // the heading as a unit vector, up to rounding
};

// Returns the robots, team after team. A robot without a body is at a vertex if it is within
// tolerance (tau L) of an end of its edge. O(n + m).
std::vector<PlacedRobot> placed_robots(const Placement& placement);

// Returns whether the object stands, and over which robots it tips (equilibrium.h). O(m log m).
Equilibrium equilibrium(const Placement& placement);

// Returns whether equilibrium alone determines the loads: whether there are at most three robots,
// and all are corners of H. O(teams).
bool loads_are_determined(const Placement& placement);

// Returns the given supports that do not fit or are too near to each other (supports.h). With other
// methods there are no misfits. O(m log n + m^2).
std::vector<Misfit> misfits(const Placement& placement);

// The loads by the models of load_models.h, in the order of the robots, and how a disturbance may
// change them. model_loads() returns nothing if there are no teams, or if the object falls. O(m log
// m), and O(m^3) up to 64 robots; with a disturbance also O(m h), or O(m^2) if heights are off.
struct ModelLoads {
  SpringLoads springs;
  double best = 0;
  std::vector<double> worst;
  Disturbance disturbance = {};
  LoadChanges changes = {};  // empty without a disturbance
};
std::optional<ModelLoads> model_loads(const Placement& placement,
                                      const Disturbance& disturbance = {});

// Returns the load of each robot by a model, for display: a range if there is a disturbance and the
// model has ranges (uncertainty.h), otherwise one value. For the model `best`, the value of every
// robot is the least possible greatest load. Without `models` the loads are as planned. O(m).
std::vector<LoadRange> loads_by(LoadModel model, const Placement& placement,
                                const std::optional<ModelLoads>& models);

// Returns whether the disturbance may change which robots carry load (uncertainty.h). O(m).
bool may_let_go(LoadModel model, const Placement& placement,
                const std::optional<ModelLoads>& models);

// Returns the planned loads, as ranges if a disturbance is given, for verdicts, requirements and
// capacities. O(m); with a disturbance, the cost of model_loads().
std::vector<LoadRange> loads_when_disturbed(const ShownPlacement& of);

// The failures and the error of C that the object survives without tipping. failures.h defines how
// failures are counted (-1 without robots), and uncertainty.h the tipping distance. O(m log m).
struct Robustness {
  int failures_carried = -1, failures_steady = -1;
  double tipping_distance = 0;
  // The number of failures after which C is still at least `clear` (document.h) inside the
  // remaining lifting base. It is at most failures_steady.
  int failures_clear = -1;
};
Robustness robustness(const Placement& placement);

// Returns when the object tips in the worst direction (tilt.h), or nothing if there are no robots
// or the height of C is 0. O(m log m).
std::optional<Tilt> tilt_of(const ShownPlacement& of);

// Returns whether the weight may act outside the lifting base, by more than the tolerance (tau L),
// under the given conditions; false if there are no robots. O(h).
bool tips_when_disturbed(const ShownPlacement& of);

// The circles about C that a picture shows, one for each of some slopes. On the slope of a circle
// the object tips, under the assumptions of tilt.h, if the circle lies outside the lifting base in
// the downhill direction. The circles are sorted from small to large and, at `scale` pixels to a
// unit of length, are far enough apart to see. A circle whose label would cover C has no label.
// There are no circles if the height of C is 0, the lifting base has no area, or the object falls.
// O(h).
struct TiltCircle {
  double degrees = 0, radius = 0;  // in units of length, with the C uncertainty
  bool is_labelled = true;
};
std::vector<TiltCircle> tilt_circles(const ShownPlacement& of, double scale);

// Return the effect of each single failure, in the order of the robots, and the effect of one
// failure, with the robot's number as for find_robot() (loads.h). An effect is nothing if the other
// robots do not carry the object. failures.h states the cost.
std::vector<std::optional<RestOfRobots>> single_failures(const Placement& placement,
                                                         const Disturbance& disturbance = {});

std::optional<RestOfRobots> single_failure(const Placement& placement, std::size_t robot,
                                           const Disturbance& disturbance = {});

// Returns the loads by springs if this robot fails, as ranges if there is a disturbance, with 0 for
// the failed robot. It returns nothing if the others do not carry the object. O(m log m); with a
// disturbance, the cost of model_loads().
std::optional<std::vector<LoadRange>> ranges_without(const Placement& placement, std::size_t robot,
                                                     const Disturbance& disturbance);

// Returns the ranges in which a team on the edges of this chord can stand, with the edge of r1 as
// edge a: the range of the two edges, if there is one, or the parts of it that robots with a size
// can use (candidates.h). O(1); with a size, O(usable intervals of a times those of b).
std::vector<PairRange> ranges_of(const Placement& placement, const Chord& chord);

// Returns the placement with its teams on other candidates, such as the best choice of optimum.h.
// O(n log n).
Placement with_choice(Placement placement, std::vector<std::uint32_t> candidates);

// Returns the placement after this robot has failed, for pictures and words. The robot stays in the
// list. H, coverage, closure and loads are those of the others, which share the weight by springs.
// If the others do not carry the object, all loads and the coverage are 0, and there is no summary
// of loads. O(n log n).
Placement with_failure(Placement placement, std::size_t robot);

}  // namespace evenlift
