// Points as Python writes them: lists and tuples, "[(0, 0), (1, 0)]", and numpy's arrays.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

// Whether the text has only numbers, commas, brackets and parentheses, and is not the thesis's
// text: it begins with "((", "[(" or "[[", or has a comma after its first pair "(x, y)". O(bytes).
bool looks_like_python(std::string_view text);

// Reads lists of points; each list is a shape. O(bytes).
Result<Import> read_python_points(std::string_view text, const ImportOptions& options);

}  // namespace evenlift
