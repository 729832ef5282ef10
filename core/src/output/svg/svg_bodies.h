// Robots with a size in a picture: the boundary that they cannot use, and they themselves to scale.
#pragma once

#include <string>

#include "evenlift/placement.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// Nothing for points that may stand anywhere. O(parts + robots).
std::string unusable_boundary(const Placement& placement, const Paper& paper);
std::string bodies(const Placement& placement, const Paper& paper);

}  // namespace evenlift::svg
