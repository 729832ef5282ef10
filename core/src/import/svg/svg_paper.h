// Boxes in which an SVG is drawn, and its size on paper.
#pragma once

#include <optional>
#include <string_view>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// The size of the box that lengths in per cent refer to, as far as it is known.
struct SvgViewport {
  std::optional<double> width, height;
};

// The rectangle of user units that a drawing shows. Nothing if the text is not four numbers.
struct SvgViewBox {
  Vec2 low = Vec2::Zero(), size = Vec2::Zero();
};
std::optional<SvgViewBox> svg_view_box(std::string_view text);

// The map from the user units of `box` to a rectangle of the given size at the origin, with
// preserveAspectRatio as `aspect` says, by default "xMidYMid meet". The sizes must be above 0.
// O(bytes).
Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

// A drawing's size, as its root element says it.
struct SvgSize {
  std::string_view width, height, view_box, aspect;
};

// The unit of a drawing on paper and the factors by which its user units are multiplied. If user
// units already are millimetres, centimetres, inches or metres, to within the rounding of programs,
// they remain and give the unit. Otherwise they become the unit in which the size is written:
// millimetres for other units than these. Without a size on paper there is no unit, and user units
// remain. Without a view box a user unit is 1/96 inch. O(bytes).
struct SvgPaper {
  LengthUnit unit = LengthUnit::none;
  double across = 1, down = 1;
  SvgViewport viewport;  // in user units
};
SvgPaper paper_of(const SvgSize& size);

}  // namespace evenlift
