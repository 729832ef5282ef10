// Where a further load, such as a person or a box, may stand.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"
#include "evenlift/vec.h"

namespace evenlift {

struct ExtraLoad {
  double weight = 0;
  // The convex part of the object's bounding box where the load makes no robot go slack and
  // overloads no robot. Its corners are counter-clockwise; it may be empty.
  Points region;
  double share = 0;  // share of the object's area (holes excluded) that is in the region
  // The greatest weight that may stand anywhere on the object; empty if there is no limit.
  std::optional<double> anywhere;
};

// The result for the weight Carrying::extra; nothing if no such weight is set, there are no robots,
// or the object falls. It presumes equally stiff, level robots and a rigid object. While all robots
// carry load, a weight w at q adds w (1/m + S^-1 (p_i - p) . (q - p)) to the load of robot i at
// p_i, where p is the robots' centroid and S the sum of (p_i - p) (p_i - p)^T. In the region, each
// load minus its change by the disturbance (uncertainty.h) is at least 0, and each load plus that
// change is at most the capacity. Without disturbance and capacities, this means that the common
// centre of mass of object and load lies in the kern (algorithm.md, Stability). If the robots stand
// on one line, the load would have to stand on that line; the region then has no area and is left
// empty. The height of the load is ignored. O(m^2 + (m + n) h) for m robots and a region of h
// corners.
std::optional<ExtraLoad> extra_load(const ShownPlacement& of);

// The loads by springs (load_models.h) while a further load of this weight stands at a place;
// nothing if the object tips. O(m log m).
std::optional<std::vector<double>> loads_with(const Placement& placement, double weight,
                                              const Vec2& at);

}  // namespace evenlift
