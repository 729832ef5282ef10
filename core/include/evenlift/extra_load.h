// Where a further load may stand, such as a person or a box.
#pragma once

#include <optional>
#include <vector>

#include "evenlift/placed_robots.h"
#include "evenlift/vec.h"

namespace evenlift {

struct ExtraLoad {
  double weight = 0;  // of the load
  // The convex polygon, within the bounding box of the object, in which the load makes no robot go
  // slack and overloads none; counter-clockwise, empty if there is no such place.
  Points region;
  double share = 0;  // the part of the object's area, without its holes, that lies in the region
  std::optional<double>
      anywhere;  // the greatest weight that may stand anywhere on the object; none
                 // means any weight
};

// The result for the weight Carrying::extra (document.h); nothing if that is not set, if there are
// no robots or if the object falls. It presumes equally stiff, level robots and a rigid object:
// while all robots carry load, a weight w at q adds w (1/m + S^-1 (p_i - p) . (q - p)) to the load
// of robot i at p_i, where p is the robots' centroid and S the sum of (p_i - p) (p_i - p)^T over
// all robots. The region is where each load minus its change by the disturbance (uncertainty.h) is
// at least 0, and each load plus that change is at most the capacity. Without a disturbance and
// without capacities, it is where the common centre of mass of object and load lies in the kern
// (algorithm.md, Stability). If the robots stand on one line, the load has no such place off that
// line, so the region has no area and is left empty. The height of the load itself is not counted.
// O(m^2 + (m + n) h) for m robots and a region of h corners.
std::optional<ExtraLoad> extra_load(const ShownPlacement& of);

// The loads by springs while this weight stands at a place; nothing if the object tips then.
// O(m log m).
std::optional<std::vector<double>> loads_with(const Placement& placement, double weight,
                                              const Vec2& at);

}  // namespace evenlift
