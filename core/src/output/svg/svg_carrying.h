// Draws the slopes at which the object tips, and the region where a further load may stand.
#pragma once

#include <string>
#include <vector>

#include "evenlift/report.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

// Fills the region where the load may stand with green, and the rest of the object with stripes.
// `rings`, the object's boundary, and `region` are in pixels.
std::string load_region(const std::vector<Points>& rings, const Points& region);
std::string load_swatch();

// Draws the circles of tilt_circles() (placed_robots.h) with their slopes. Empty if there are none.
std::string tilt_marks(const ShownPlacement& of, const Paper& paper);
std::string tilt_swatch();

}  // namespace evenlift::svg
