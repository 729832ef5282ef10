// Reads polygons, multipolygons and collections in well-known text, alone or in a column of a
// table. Other geometries, such as points, are left out.
#pragma once

#include <string_view>

#include "evenlift/import.h"

namespace evenlift {

// Reads a text of one or more geometries, each perhaps followed by ';'.
Result<Import> read_wkt_shapes(std::string_view text, const ImportOptions& options);

// Reads a table of geometries, one per line. A column of names or numbers, if any, names them.
Result<Import> read_wkt_table(std::string_view text, const ImportOptions& options);

// Whether one of the first 100 lines of a table has WKT. But returns false if an earlier line
// names columns of coordinates and the first WKT is a point, which repeats them. O(100 lines).
bool has_wkt_cells(std::string_view text);

// --- Reads points as Python writes them: lists and tuples, such as "[(0, 0), (1, 0)]", and numpy's
// arrays.

// Whether the text has only numbers, commas, brackets and parentheses, and either begins with two
// brackets or parentheses, such as "[(", or has a comma after its first "(x, y)". The thesis's
// format has no such comma. O(bytes).
bool looks_like_python(std::string_view text);

// Reads each list of points as a shape. O(bytes).
Result<Import> read_python_points(std::string_view text, const ImportOptions& options);

}  // namespace evenlift
