// The discs of the robots; robots at almost the same place share one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evenlift/plane.h"
#include "evenlift/report.h"
#include "output/svg/svg_paper.h"

namespace evenlift::svg {

struct Stand {
  Vec2 at;                          // in pixels
  std::string numbers;              // "3", "1·4", "×5" for five robots
  std::size_t team = 0;             // from 1; 0 if robots share it or are not in teams of two
  std::vector<LoadRange> loads;     // the robots' loads
  std::vector<std::size_t> robots;  // their numbers (loads.h)
  std::optional<Box> body;          // the first robot's, if robots have a size
  bool beneath = false;             // beneath the object (supports.h)
};

// Robots closer than `apart` pixels share a stand, but a robot beneath the object never shares one
// with a robot at the edge. Stands are in the order of the teams. `sized` contains all robots if
// they have a size; otherwise it is empty. `loads` is empty if the object falls.
// O(robots * stands); a picture has room for a few thousand stands.
std::vector<Stand> find_stands(const Placement& placement, const std::vector<PlacedRobot>& sized,
                               const std::vector<LoadRange>& loads, const Paper& paper,
                               double apart);

// Writes a stand's load: "16.7 kg" or "14.2–19.2 kg"; for several robots "2 × 16.7 kg", "16.7 +
// 15.9 kg" or the sum, "Σ 50.1 kg". `largest` sets the number of decimals, as for amount()
// (words.h).
std::string load_text(const Stand& stand, double largest, const Units& units);

}  // namespace evenlift::svg
