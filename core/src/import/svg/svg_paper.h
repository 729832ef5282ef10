// The boxes and the paper of an SVG.
#pragma once

#include <optional>
#include <string_view>

#include "curves/outline.h"
#include "evenlift/document.h"
#include "evenlift/vec.h"

namespace evenlift {

// The box for lengths in per cent, as far as known.
struct SvgViewport {
  std::optional<double> width, height;
};

// The user units that are drawn. Nothing if the text is not four numbers.
struct SvgViewBox {
  Vec2 low = Vec2::Zero(), size = Vec2::Zero();
};
std::optional<SvgViewBox> svg_view_box(std::string_view text);

// From the user units of `box` to a rectangle of this size at the origin, by the
// preserveAspectRatio `aspect`, by default "xMidYMid meet". The sizes must be above 0. O(bytes).
Affine fitted(const SvgViewBox& box, const Vec2& size, std::string_view aspect);

// As the root element says it.
struct SvgSize {
  std::string_view width, height, view_box, aspect;
};

// The unit of a drawing on paper and the factors of its user units. User units remain and give the
// unit if they are millimetres, centimetres, inches or metres, up to the rounding of programs.
// Others become the unit of the written size, or millimetres if it is none of these. Without a size
// on paper there is no unit, and user units remain. Without a view box a user unit is 1/96 inch.
// O(bytes).
struct SvgPaper {
  LengthUnit unit = LengthUnit::none;
  double across = 1, down = 1;
  SvgViewport viewport;  // in user units
};
SvgPaper paper_of(const SvgSize& size);

}  // namespace evenlift
