// Finds holes: outlines that lie inside others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// How a drawing fills an outline: not at all, or by one of the two rules of SVG.
enum class Fill : std::uint8_t { none, nonzero, even_odd };

// An outline that is a shape, and the outlines that are its holes, by their numbers.
struct OutlineWithHoles {
  std::size_t outline;
  std::vector<std::size_t> holes;
};

// The shapes that a path of several rings fills, in the order of their outlines' areas, the largest
// first. A ring is a hole if it is filled around but not inside; of a ring with only filled places on
// both sides the inside is a shape of its own. Rings may touch. Rings that cross are separate
// shapes. O(k^2 + n) for k rings of n vertices in all, plus O(m) for up to 256 vertices of each ring
// in the box of one with m.
std::vector<OutlineWithHoles> filled_shapes(const std::vector<const Points*>& rings, Fill fill);

// A closed outline of a drawing. One that is filled may have holes by its fill.
struct ClosedOutline {
  const Points* points = nullptr;
  const std::vector<Points>* holes = nullptr;  // or null for none
  bool filled = false;
};

struct Nesting {
  std::vector<OutlineWithHoles> shapes;  // by area, the largest first; of equal ones by coordinates
  std::size_t holes = 0;                 // in all, without those that filled outlines came with
  std::size_t repeated = 0;              // outlines that repeat another exactly, and were dropped
};

// Makes holes of outlines by depth. A filled outline is a shape wherever it lies. One without a fill
// that is directly inside a shape is a hole of it; otherwise, also in a hole, it is a shape. Outlines
// that cross or touch are separate shapes. The shapes do not depend on the order of the outlines.
// O(k^2 + n) for k outlines of n vertices in all, plus O(m) for up to 256 vertices of each outline in
// the box of one with m.
Nesting nest(const std::vector<ClosedOutline>& outlines);

}  // namespace evenlift
