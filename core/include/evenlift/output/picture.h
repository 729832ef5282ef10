// A Placement as shapes with roles, in polygon coordinates: no colours, no pixels. The SVG writer
// and the page's canvas both draw it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "evenlift/placement.h"

namespace evenlift {

enum class Role : std::uint8_t {
  object,            // filled polygon P
  lifting_base,      // filled lifting base H
  clockwise,         // filled region of free clockwise rotation centres
  counterclockwise,  // filled region of free counter-clockwise ones
  candidate,         // a candidate chord that no team took
  chord,             // a team's chord
  robot,             // a lifting point
  centre_of_mass,
};

struct Shape {
  Role role = Role::object;
  Points points;           // closed area (3 or more), segment (2) or spot (1)
  std::int32_t team = -1;  // for chords and robots: index of the team
  double load = 0;         // for robots
};

// Back to front, only what the overlays ask for. Of more than `most_lines` candidates, or chords,
// every second, third … one is shown: nobody could tell them apart. O(output).
std::vector<Shape> make_picture(const Placement& placement, const Overlays& overlays,
                                std::size_t most_lines = SIZE_MAX);

}  // namespace evenlift
