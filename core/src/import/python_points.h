// Points in Python: lists and tuples, "[(0, 0), (1, 0)]", and numpy's arrays.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

// Whether the text has only numbers, commas, brackets and parentheses, and begins with "((", "[("
// or "[[" or has a comma after its first "(x, y)", unlike the thesis's text. O(bytes).
bool looks_like_python(std::string_view text);

// Each list of points is a shape. O(bytes).
Result<Import> read_python_points(std::string_view text, const ImportOptions& options);

}  // namespace evenlift
