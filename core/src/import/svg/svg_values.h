// Parsers of SVG attributes: numbers, lengths, transforms and paths.
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

// The problem with an attribute, as part of a sentence, such as "character 7: not a number".
struct SvgProblem {
  std::string what;
};
template <class T>
using SvgResult = std::variant<T, SvgProblem>;

// The numbers of a list, separated by white space and commas. O(bytes).
SvgResult<std::vector<double>> svg_numbers(std::string_view text);

// The text without white space and commas at its ends. O(bytes).
std::string_view svg_trimmed(std::string_view text);

// A length in user units: a number, perhaps with a unit such as mm, or in per cent of `whole`. An
// inch has 96 user units. Empty text and "auto" give nullopt. O(bytes).
SvgResult<std::optional<double>> svg_length(std::string_view text,
                                            std::optional<double> whole = std::nullopt);

// A transform as in the attribute, or as in CSS, where arguments have units and more functions are
// known: translateX(1mm), rotate(90deg), skew(1rad). Empty text and "none" give the identity.
// O(bytes).
SvgResult<Affine> svg_transform(std::string_view text);

// The point of transform-origin, such as "center", "10px 20px" or "left 25%", in a box at the
// origin of the given width and height, as far as they are known. Empty text gives the origin.
// O(bytes).
SvgResult<Vec2> svg_transform_origin(std::string_view text, std::optional<double> width,
                                     std::optional<double> height);

// The outlines of a path, one for each of its parts.
struct SvgOutline {
  Outline outline;
  bool closed;
};
SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text);

}  // namespace evenlift
