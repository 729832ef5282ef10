// Robots with a size in a picture: the boundary that they cannot use, and they themselves to scale.
#pragma once

#include <string>

#include "evenlift/placement.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// What the paper must have room for: the vertices, and around them the robots' bodies. O(n + robots).
Points extent(const Placement& placement);

// Nothing for points that may stand anywhere. O(parts + robots).
std::string unusable_boundary(const Placement& placement, const Paper& paper);
std::string bodies(const Placement& placement, const Paper& paper);

}  // namespace evenlift::svg
