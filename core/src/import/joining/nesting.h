// Finds holes among outlines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evenlift/vec.h"

namespace evenlift {

// How a drawing fills an outline: not at all, or by a rule of SVG.
enum class Fill : std::uint8_t { none, nonzero, even_odd };

// A shape and its holes, by the indices of their outlines.
struct OutlineWithHoles {
  std::size_t outline;
  std::vector<std::size_t> holes;
};

// The shapes that a path of several rings fills, the largest first. A ring is a hole if the area
// just outside the ring is filled but the area just inside it is not. If both are filled, the ring
// is a shape of its own. Rings may touch. Rings that cross are separate shapes. O(k^2 + n) for k
// rings of n vertices in all. In addition, for each ring whose box lies in the box of another ring
// with m vertices, up to 256 vertices of the inner ring take O(m) each.
std::vector<OutlineWithHoles> filled_shapes(const std::vector<const Points*>& rings, Fill fill);

// An outline to nest. A filled outline may have holes that come from its fill.
struct ClosedOutline {
  const Points* points = nullptr;
  const std::vector<Points>* holes = nullptr;  // null if there are no holes
  bool filled = false;
  bool looks_like_sheet = false;  // by its name or its paint
  bool fills_page = false;        // as large as the page
};

struct Nesting {
  std::vector<OutlineWithHoles>
      shapes;                // the largest first; equal areas by coordinates; sheets last
  std::size_t sheets = 0;    // the number of sheets. Their holes are also shapes
  std::size_t holes = 0;     // the number of holes, except those of filled outlines
  std::size_t repeated = 0;  // the number of exact repetitions that were dropped
};

// Decides which outlines are holes. A filled outline is always a shape. An outline without a fill
// is a hole if it is directly inside a shape. Otherwise it is a shape, even inside a hole. Outlines
// that cross or touch are separate shapes. A rectangle that encloses all other outlines is a sheet if
// it looks like one, or if it holds several outlines, one of them with a hole of its own; what lies on it is
// nested as if it were not there. The order of the outlines does not matter. The complexity is that of
// filled_shapes().
Nesting nest(const std::vector<ClosedOutline>& outlines);

}  // namespace evenlift
