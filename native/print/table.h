#pragma once

#include <string>
#include <vector>

namespace evenlift::native {

using Row = std::vector<std::string>;

// Returns a table with right-aligned columns, two spaces apart and as wide as necessary. The first
// row, which must exist, has the headings. Other rows may have fewer cells. The remark with the
// index of a row, if any, follows the last cell of that row.
std::string table(const std::vector<Row>& rows, const std::vector<std::string>& remarks = {});

}  // namespace evenlift::native
