// Parsers of SVG attributes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "curves/outline.h"
#include "evenlift/result.h"

namespace evenlift {

// A problem, as part of a sentence, such as "character 7: not a number".
struct SvgProblem {
  std::string what;
};
template <class T>
using SvgResult = std::variant<T, SvgProblem>;

// Reads a list of numbers separated by white space and commas. O(bytes).
SvgResult<std::vector<double>> svg_numbers(std::string_view text);

// The text without white space and commas at its ends. O(bytes).
std::string_view svg_trimmed(std::string_view text);

// Returns a length in user units. The text is a number, perhaps with a unit such as mm or with %,
// which means per cent of `whole`. An inch is 96 user units. Empty text and "auto" give nullopt.
// O(bytes).
SvgResult<std::optional<double>> svg_length(std::string_view text,
                                            std::optional<double> whole = std::nullopt);

// Moves every point by (x, y).
Affine translation(double x, double y);

// Reads a transform in the syntax of the attribute, or of CSS, which also has units and more
// functions: translateX(1mm), rotate(90deg), skew(1rad). Empty text and "none" give the identity.
// O(bytes).
SvgResult<Affine> svg_transform(std::string_view text);

// Reads a point such as "center", "10px 20px" or "left 25%" in a box at the origin. A point that
// depends on an unknown width or height of the box is a problem. Empty text gives the origin.
// O(bytes).
SvgResult<Vec2> svg_transform_origin(std::string_view text, std::optional<double> width,
                                     std::optional<double> height);

// One part of a path.
struct SvgOutline {
  Outline outline;
  bool closed;
};
SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text);

}  // namespace evenlift
