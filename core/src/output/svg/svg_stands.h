// The robots of a picture. Each has a disc; several at almost the same place share one.
#pragma once

#include <string>
#include <vector>

#include "evenlift/placement.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

struct Stand {
  Vec2 at = Vec2::Zero();     // in pixels
  std::string numbers;        // of the teams, or of balanced robots: "3", "1·4", "×5" for five
  std::vector<double> loads;  // of the robots
};

// Robots nearer to each other than `apart` pixels share a stand. The first teams first.
// O(robots * stands), of which a picture has room for some thousands.
std::vector<Stand> find_stands(const Placement& placement, const Paper& paper, double apart);

// "16.7"; of several robots "2 × 16.7", "16.7 + 15.9" or their sum, "Σ 50.1".
std::string load_text(const Stand& stand, double largest);

}  // namespace evenlift::svg
