// What the canvas draws, kept from frame to frame: the picture's shapes and the object as
// triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "evenlift/output/picture.h"
#include "labels.h"
#include "state.h"

namespace evenlift::view {

struct Scene {
  std::uint64_t revision = 0;
  std::vector<Shape> shapes;             // of the last good placement, as the overlays ask
  std::vector<std::uint32_t> triangles;  // of its polygon
  CoveragePlace coverage;                // where coverage is written, if there is room
};

// Follows the state; costs nothing while the document stays as it is.
void follow(Scene& scene, const AppState& state);

}  // namespace evenlift::view
