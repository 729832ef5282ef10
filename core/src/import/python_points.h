// Reads points as Python writes them: lists and tuples, such as "[(0, 0), (1, 0)]", and numpy's
// arrays.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

// Whether the text has only numbers, commas, brackets and parentheses, and either begins with two
// brackets or parentheses, such as "[(", or has a comma after its first "(x, y)". The thesis's
// format has no such comma. O(bytes).
bool looks_like_python(std::string_view text);

// Reads each list of points as a shape. O(bytes).
Result<Import> read_python_points(std::string_view text, const ImportOptions& options);

}  // namespace evenlift
