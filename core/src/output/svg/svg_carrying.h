// Draws the slopes at which the object tips, and the region where a further load may stand.
#pragma once

#include <string>
#include <vector>

#include "evenlift/placement.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// Draws the region green, and the rest of the object striped. Both are in pixels.
std::string load_region(const std::vector<Points>& rings, const Points& region);
std::string load_swatch();

// Draws circles about C, up to the farthest corner of the lifting base. Empty if C has no height or
// the object falls.
std::string tilt_marks(const ShownPlacement& of, const Paper& paper);
std::string tilt_swatch();

}  // namespace evenlift::svg
