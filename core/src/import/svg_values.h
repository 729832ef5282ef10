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

// A length in user units: a number, perhaps with a unit such as mm. An inch has 96 user units.
// Empty text and "auto" give nullopt.
SvgResult<std::optional<double>> svg_length(std::string_view text);

SvgResult<Affine> svg_transform(std::string_view text);

// The outlines of a path, one for each of its parts.
struct SvgOutline {
  Outline outline;
  bool closed;
};
SvgResult<std::vector<SvgOutline>> svg_path(std::string_view text);

}  // namespace evenlift
