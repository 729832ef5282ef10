// Reads the view box of an SVG and its size on paper.
#pragma once

#include <optional>
#include <string_view>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// The width and height to which lengths in per cent refer; either may be unknown.
struct SvgViewport {
  std::optional<double> width, height;
};

// The rectangle that is drawn, in user units. svg_view_box() returns nullopt if the text is not
// four numbers.
struct SvgViewBox {
  Vec2 low, size;
};
std::optional<SvgViewBox> svg_view_box(std::string_view text);

// Returns the map from `box`, in user units, to a rectangle of this size with a corner at the
// origin. `aspect` is the value of preserveAspectRatio; if empty, it counts as "xMidYMid meet". The
// sizes of both must be above 0. O(bytes).
Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

// The attributes of the root element that give the drawing's size.
struct SvgSize {
  std::string_view width, height, view_box, aspect;
};

// The unit of a drawing on paper, and the factors from its user units to this unit. Without a size
// on paper there is no unit, and the factors are 1. Without a view box, a user unit is 1/96 inch.
// If a user unit is a millimetre, centimetre, inch or metre, up to the rounding of programs, this
// is the unit, and the factors are 1. Otherwise the unit is that of the written size, or
// millimetres if the size is in pt, pc or Q. paper_of() takes O(bytes).
struct SvgPaper {
  LengthUnit unit = LengthUnit::none;
  double across = 1, down = 1;
  SvgViewport viewport;  // in user units
};
SvgPaper paper_of(const SvgSize& size);

}  // namespace evenlift
