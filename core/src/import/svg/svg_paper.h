// The boxes and the paper of an SVG.
#pragma once

#include <optional>
#include <string_view>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// The box that is 100 per cent for lengths in per cent, as far as it is known.
struct SvgViewport {
  std::optional<double> width, height;
};

// The rectangle of user units that is drawn. svg_view_box() returns nullopt if the text is not four
// numbers.
struct SvgViewBox {
  Vec2 low = Vec2::Zero(), size = Vec2::Zero();
};
std::optional<SvgViewBox> svg_view_box(std::string_view text);

// Maps the user units of `box` to a rectangle of this size at the origin. `aspect` is a
// preserveAspectRatio; the default is "xMidYMid meet". The sizes must be above 0. O(bytes).
Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

// The attributes of the root element that give the drawing's size.
struct SvgSize {
  std::string_view width, height, view_box, aspect;
};

// The unit of a drawing on paper, and the factors from its user units to this unit. If user units
// are millimetres, centimetres, inches or metres, up to the rounding of programs, they remain and
// give the unit. Otherwise they become the unit of the written size, or millimetres if that unit is
// pt, pc or Q. Without a size on paper there is no unit, and user units remain. Without a view box,
// a user unit is 1/96 inch. paper_of() takes O(bytes).
struct SvgPaper {
  LengthUnit unit = LengthUnit::none;
  double across = 1, down = 1;
  SvgViewport viewport;  // in user units
};
SvgPaper paper_of(const SvgSize& size);

}  // namespace evenlift
