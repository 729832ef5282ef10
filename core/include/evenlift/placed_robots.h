// The robots of a placement one by one: where they stand and face, what they bear by each model,
// and how much may go wrong. Nothing of this is part of place(): who shows it asks for it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "evenlift/doubt.h"
#include "evenlift/failures.h"
#include "evenlift/load_models.h"
#include "evenlift/placement.h"

namespace evenlift {

struct PlacedRobot {
  Vec2 at = Vec2::Zero();       // where it lifts
  Vec2 contact = Vec2::Zero();  // where it touches the boundary
  Vec2 stand = Vec2::Zero();    // the middle of its body
  std::uint32_t team = 0;
  double load = 0;  // by plan
  // The direction of the inward normal there, in (-180, 180]; of a point at a vertex the middle
  // between those of its two edges.
  double heading_deg = 0;
  Vec2 direction = Vec2(1, 0);  // the same as a vector of length 1, up to rounding
};

// The robots, team after team. A robot is at a vertex if it is within tolerance (tau L) of an end
// of its edge. O(n + m).
std::vector<PlacedRobot> placed_robots(const Placement& placement);

// The loads by the models of load_models.h, in the order of the robots. None if there are no teams
// or C is not above H, which only rounding can bring about. O(m log m), and O(m^3) up to 64 robots.
struct ModelLoads {
  SpringLoads springs;
  double best = 0;
  std::vector<double> worst;
};
std::optional<ModelLoads> model_loads(const Placement& placement);

// What each robot bears by a model, as people are shown it: a range if C is known only within
// `com_radius` > 0 and the model has ranges (doubt.h says how far they are exact), and otherwise
// one value. Of the best loads only the greatest is known, so each robot has that. Without `models`
// the loads are those of the plan. O(m).
std::vector<LoadRange> loads_by(LoadModel model, const Placement& placement,
                                const std::optional<ModelLoads>& models, double com_radius);

// How much may go wrong before the object is not carried any more or tips. failures.h says how
// failures are counted (-1 without robots), and doubt.h what the distance is. O(m log m).
struct Robustness {
  int failures_carried = -1, failures_steady = -1;
  double tipping_distance = 0;
  // How many may fail so that C stays at least `clear` (document.h) inside what is left of the
  // base. Never more than failures_steady.
  int failures_clear = -1;
};
Robustness robustness(const Placement& placement);

// What happens if one robot fails, for each of them; failures.h says at which cost.
std::vector<std::optional<RestOfRobots>> single_failures(const Placement& placement);

// The same of one robot, as find_robot() (loads.h) counts them.
std::optional<RestOfRobots> single_failure(const Placement& placement, std::size_t robot);

// What the others bear by springs if the robot with this number fails, in the row of all robots, in
// which it bears nothing itself. None if the others do not carry the object. O(m log m).
std::optional<SpringLoads> springs_without(const Placement& placement, std::size_t robot);

// Where a team on the edges of this chord can stand, edge a being that of r1: their range, if they
// have one; or with a size what it leaves of that (candidates.h). O(1), and O(stretches of a times
// those of b).
std::vector<PairRange> ranges_of(const Placement& placement, const Chord& chord);

// The placement with its teams on these of its candidates, such as the best choice of optimum.h, in
// place of those that the method chose. O(n log n).
Placement with_choice(Placement placement, std::vector<std::uint32_t> candidates);

// The placement while the robot with this number fails, for pictures and words. All robots are
// still in their row; H, coverage, closure and loads are those of the others, who share the weight
// by springs. Where they do not carry the object nobody bears anything, there is no summary of
// loads, and the coverage is 0. O(n log n).
Placement with_failure(Placement placement, std::size_t robot);

}  // namespace evenlift
