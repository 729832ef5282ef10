// Finds holes among outlines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// How a drawing fills an outline: not at all, or by a rule of SVG.
enum class Fill : std::uint8_t { none, nonzero, even_odd };

// A shape and its holes, by the numbers of their outlines.
struct OutlineWithHoles {
  std::size_t outline;
  std::vector<std::size_t> holes;
};

// The shapes that a path of several rings fills, the largest first. A ring is a hole if it is
// filled around but not inside. If both sides are filled, the inside is a shape of its own. Rings
// may touch. Rings that cross are separate shapes. O(k^2 + n) for k rings of n vertices in all,
// plus O(m) for up to 256 vertices of each ring in the box of one with m.
std::vector<OutlineWithHoles> filled_shapes(const std::vector<const Points*>& rings, Fill fill);

// A filled one may have holes by its fill.
struct ClosedOutline {
  const Points* points = nullptr;
  const std::vector<Points>* holes = nullptr;  // or null for none
  bool filled = false;
};

struct Nesting {
  std::vector<OutlineWithHoles> shapes;  // by area, the largest first; of equal ones by coordinates
  std::size_t holes = 0;                 // in all, without those of filled outlines
  std::size_t repeated = 0;              // exact repetitions, which were dropped
};

// Makes holes by depth. A filled outline is always a shape. One without a fill is a hole if it is
// directly inside a shape, else, also in a hole, a shape. Outlines that cross or touch are separate
// shapes. The order does not matter. The complexity is that of filled_shapes.
Nesting nest(const std::vector<ClosedOutline>& outlines);

}  // namespace evenlift
