// Finds holes: outlines that lie inside others.
#pragma once

#include <cstddef>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// An outline that is a shape, and the outlines that are its holes, by their numbers.
struct OutlineWithHoles {
  std::size_t outline;
  std::vector<std::size_t> holes;
};

struct Nesting {
  std::vector<OutlineWithHoles> shapes;  // by area, the largest first; of equal ones by coordinates
  std::size_t holes = 0;                 // in all
  std::size_t repeated = 0;              // outlines that repeat another exactly, and were dropped
};

// Makes holes of outlines by depth: an outline directly inside a shape is its hole, one inside that
// hole is a shape again, and so on. Outlines that cross or touch are
// separate shapes. The shapes do not depend
// on the order of the outlines. O(k^2 + n) for k outlines of n vertices in all, plus O(m) for
// up to 256 vertices of each outline in the box of one with m.
Nesting nest(const std::vector<const Points*>& outlines);

}  // namespace evenlift
