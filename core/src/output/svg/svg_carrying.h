// The slopes at which the object tips, and where a further load may stand, in a picture.
#pragma once

#include <string>
#include <vector>

#include "evenlift/placement.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// The object's visible rings with the region in green and the rest striped. Both are in pixels.
std::string load_region(const std::vector<Points>& rings, const Points& region);
std::string load_swatch();

// Circles about C for slopes, up to the farthest corner of the lifting base. Empty without a height
// of C, or if the object falls.
std::string tilt_marks(const ShownPlacement& of, const Paper& paper);
std::string tilt_swatch();

}  // namespace evenlift::svg
